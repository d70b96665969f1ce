/// roll_pitch_yaw.h - rotations as angles about the fixed axes x, y, z: R = R_z(yaw) R_y(pitch) R_x(roll).
///
/// Source: URDF XML specification, "joint".
#pragma once

#include <cmath>

#include "murosimf/math/mat3.h"

namespace murosimf {

/// `rpy`: roll, pitch, yaw [rad].
[[nodiscard]] inline Mat3d from_roll_pitch_yaw(const Vec3d& rpy) {
  return rotation_z(rpy.z) * rotation_y(rpy.y) * rotation_x(rpy.x);
}

/// [rad] As exact as R, also where pitch is a right angle: roll is that of what is left without yaw, and yaw is 0 where only the sum of
/// both matters.
[[nodiscard]] inline Vec3d roll_pitch_yaw(const Mat3d& R) {
  constexpr double rounding = 5e-16;  // [1] of what is zero
  const double yaw = std::hypot(R.x.x, R.x.y) < rounding ? 0 : std::atan2(R.x.y, R.x.x);
  const double s = std::sin(yaw), c = std::cos(yaw);
  // columns of R_z(-yaw) R = R_y(pitch) R_x(roll); its second row is (0, cos roll, -sin roll)
  const double pitch = std::atan2(-R.x.z, c * R.x.x + s * R.x.y);
  const double roll = std::atan2(s * R.z.x - c * R.z.y, c * R.y.y - s * R.y.x);
  return {roll, pitch, yaw};
}

}  // namespace murosimf
