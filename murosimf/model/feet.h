/// feet.h - what a model stands on: its soles, and what belongs to the foot of each.
///
/// The one rule for models: an object is a sole if it has the property `sole`; a body or shape belongs to a foot if it moves
/// with the link of that sole. Which frames of a robot's file become soles is decided before, in robot/robot_soles.h.
#pragma once

#include <cmath>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/model/shape.h"

namespace murosimf {

struct Foot {
  int object = 0;     ///< the sole's frame: x forward, z up
  FixedObject place;  ///< of that frame on its link
  Sole sole;
};

/// In the order of the objects: the first sole, the second, ...
[[nodiscard]] std::vector<Foot> feet_of(const Model& model);

/// Whether an object moves with the link of the foot's sole.
[[nodiscard]] inline bool belongs_to(const Model& model, const Foot& foot, int object) {
  return model.tree().link_of[object] == foot.place.link;
}

/// Height [m] of the lowest corner of a sole whose frame is at `r` [m] with the axes `R`, world frame.
[[nodiscard]] inline double lowest_corner(const Sole& sole, const Vec3d& r, const Mat3d& R) noexcept {
  return r.z - sole.half_length * std::abs(R.x.z) - sole.half_width * std::abs(R.y.z);
}

}  // namespace murosimf
