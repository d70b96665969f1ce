/// leg_ik.h - inverse kinematics of a leg with intersecting hip axes and intersecting ankle axes, in closed form.
///
/// With the ankle at a (from the hip center, base axes) and the foot turned by R_f:
///     r = R_f^T (-a)      C = |r|      knee = acos((C^2 - l1^2 - l2^2) / (2 l1 l2))
///     alpha = atan2(l1 sin(knee), l2 + l1 cos(knee))           between the shin and the line to the hip
///     ankle roll = atan2(r_y, r_z)     ankle pitch = -atan2(r_x, sign(r_z) |(r_y, r_z)|) - alpha
///     hip yaw, roll, pitch from R_f Rx(-ankle roll) Ry(-ankle pitch - knee)
/// Source:  Kajita, Hirukawa, Harada, Yokoi, Introduction to Humanoid Robotics (2014), section 2.5.
/// Differs: alpha there is asin(l1/C sin(pi - knee)), which is wrong where a long thigh folds it beyond 90 degrees.
#pragma once

#include <array>

#include "murosimf/math/mat3.h"

namespace murosimf::locomotion {

struct LegAngles {
  std::array<double, 6> q{};  ///< [rad] hip yaw, roll, pitch, knee, ankle pitch, roll; knee bends with q > 0
  bool reachable = true;      ///< false: the target was too far and the leg points at it, nearly straight
};

/// `ankle` [m] from the hip center, base axes; `foot` its axes in base axes; lengths [m].
[[nodiscard]] LegAngles leg_angles(double thigh, double shin, const Vec3d& ankle, const Mat3d& foot) noexcept;

}  // namespace murosimf::locomotion
