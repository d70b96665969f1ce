/// attitude_filter.h - which way is up, from a gyroscope and an accelerometer: a complementary filter that learns the gyroscope's bias.
///
/// In axes of the robot's base, w the gyroscope, f the accelerometer in units of g, u the estimate of the unit vector upward, b that of
/// the bias, T the time constant `trust`:
///
///     e = f x u            u' = u x (w - b + e/T)            b' = -e/T_b^2
///
/// f is not made a unit vector: specific force is gravity plus the acceleration, with a mean over the steps of a walk at constant speed
/// is zero; the mean of its direction is not, as hard footfalls point along the leg. Linearised at rest the poles are those of
/// s^2 + s/T + 1/T_b^2. A filter without b is off by b T: 0.005 rad/s and 8 s are 2.3 degrees.
/// While the robot does not move, f is gravity and w is b: both are followed with the short time constant `still`.
/// Source: Mahony, Hamel, Pflimlin, "Nonlinear Complementary Filters on the Special Orthogonal Group", IEEE TAC 53 (2008), explicit
/// form for one vector.
#pragma once

#include "murosimf/math/vec3.h"

namespace murosimf::locomotion {

struct AttitudeTrust {
  double accelerometer = 3;  ///< [s] T
  double bias = 10;          ///< [s] T_b
  double still = 0.5;        ///< [s]
};

struct AttitudeFilter {
  Vec3d up{0, 0, 1};  ///< [1] u
  Vec3d bias;         ///< [rad/s] b

  /// Starts at rest. `force` [m/s^2]: specific force in axes of the base.
  void start(const Vec3d& force) noexcept;
  /// Advances by `dt` [s]. `gyroscope` [rad/s], `force` [m/s^2] specific force, both in axes of the base. `gravity` [m/s^2], above 0.
  void follow(double dt, const Vec3d& gyroscope, const Vec3d& force, double gravity, const AttitudeTrust& trust,
              bool still) noexcept;

  [[nodiscard]] double pitch() const noexcept;  ///< [rad] forward
  [[nodiscard]] double roll() const noexcept;   ///< [rad] to the right
};

}  // namespace murosimf::locomotion
