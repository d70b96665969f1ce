/// jersey_numbers.h - places of a player's number: on chest and back of its trunk.
///
/// The trunk is the base, or one of the links that carry two limbs at least, whichever fills the largest box. A plate is
/// 60 % as wide as the trunk and at most as high as wide, in the middle of the trunk, and lies 1 mm in front of the
/// outermost surface that is behind it. Forward is x of the base, joints at zero.
#pragma once

#include <vector>

#include "murosimf/appearance/visual_meshes.h"
#include "murosimf/geometry/triangle_mesh.h"
#include "murosimf/model/model.h"

namespace murosimf::appearance {

/// A rectangle that moves with an object.
struct JerseyNumber {
  int object = 0;          ///< of the model: base or joint
  Vec3d center;            ///< [m] object frame
  Vec3d right, up;         ///< [1] unit, object frame, as seen by a reader; right x up points away from the robot
  double half_width = 0;   ///< [m] along right
  double half_height = 0;  ///< [m] along up
};

/// Chest and back, in this order; none if nothing of the trunk is visible. `appearance`: of the model, reduced or not.
[[nodiscard]] std::vector<JerseyNumber> jersey_numbers(const Model& model, const Appearance& appearance);

/// The number as large as the plate allows, in the frame of the plate's object. Throws SetupError for a negative number.
[[nodiscard]] geometry::TriangleMesh number_on(const JerseyNumber& plate, int number);

}  // namespace murosimf::appearance
