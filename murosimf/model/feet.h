/// feet.h - the feet of a model: its soles, and the bodies that belong to each foot.
///
/// The one rule for models: an object is a sole if it has the property `sole`; a body or shape belongs to a foot if it moves
/// with the link of that sole. robot/robot_soles.h selects the frames of a robot's file that become soles.
#pragma once

#include <cmath>
#include <vector>

#include "murosimf/math/assert.h"
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
  MUROSIMF_ASSERT(object >= 0 && object < model.size());
  return model.tree().link_of[object] == foot.place.link;
}

/// Height [m] of the lowest corner of a sole whose frame is at `r` [m] with the axes `R`, world frame.
[[nodiscard]] inline double lowest_corner(const Sole& sole, const Vec3d& r, const Mat3d& R) noexcept {
  MUROSIMF_ASSERT(sole.half_length >= 0 && sole.half_width >= 0);
  return r.z - sole.half_length * std::abs(R.x.z) - sole.half_width * std::abs(R.y.z);
}

}  // namespace murosimf
