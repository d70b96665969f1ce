// Attitude: against the exact attitude of bodies that turn, shake and carry sensors with a bias.
#include "murosimf/locomotion/attitude_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "murosimf/math/mat3.h"

namespace murosimf::locomotion {
namespace {

constexpr double g = 9.81;    // [m/s^2]
constexpr double dt = 0.005;  // [s]

/// The body's axes R(t), rate w in them and acceleration a of the sensor in the world, at any time.
template <class Attitude, class Rate, class Acceleration>
AttitudeFilter follow(double duration, const Attitude& R, const Rate& w, const Acceleration& a, const Vec3d& bias,
                      const AttitudeTrust& trust = {}) {
  AttitudeFilter filter;
  filter.start(transposed_times(R(0.0), Vec3d{0, 0, g}));
  for (double t = 0; t < duration; t += dt) {
    const double middle = t + dt / 2, end = t + dt;
    filter.follow(dt, w(middle) + bias, transposed_times(R(end), a(end) + Vec3d{0, 0, g}), g, trust, false);
  }
  return filter;
}

const auto no_acceleration = [](double) { return Vec3d{}; };

TEST(AttitudeFilter, ReadsPitchForwardAndRollToTheRight) {
  AttitudeFilter filter;
  filter.up = transposed_times(rotation_y(0.3), Vec3d{0, 0, 1});
  EXPECT_NEAR(filter.pitch(), 0.3, 1e-15);
  EXPECT_NEAR(filter.roll(), 0, 1e-15);
  filter.up = transposed_times(rotation_y(0.3) * rotation_x(-0.2), Vec3d{0, 0, 1});
  EXPECT_NEAR(filter.pitch(), 0.3, 1e-15);
  EXPECT_NEAR(filter.roll(), -0.2, 1e-15);
}

TEST(AttitudeFilter, FollowsATurnThatGyroscopeAndGravityAgreeOn) {
  const auto angle = [](double t) { return 0.6 * std::sin(3 * t); };
  const auto R = [&](double t) { return rotation_y(angle(t)); };
  const auto w = [](double t) { return Vec3d{0, 1.8 * std::cos(3 * t), 0}; };
  const double end = 10;
  const AttitudeFilter filter = follow(end, R, w, no_acceleration, {});
  // Euler steps of 5 ms at 1.8 rad/s: w^2 dt^2/2 a step, most of which cancels
  EXPECT_NEAR(filter.pitch(), angle(end), 2e-3);
  EXPECT_NEAR(norm(filter.up), 1, 1e-15);
}

TEST(AttitudeFilter, LearnsTheBiasOfItsGyroscope) {
  const Vec3d bias{0.02, -0.03, 0};
  const auto R = [](double) { return Mat3d{}; };
  const AttitudeFilter after_a_while = follow(5, R, no_acceleration, no_acceleration, bias);
  const AttitudeFilter later = follow(300, R, no_acceleration, no_acceleration, bias);
  // Before b is known the tilt goes to b T, then back with the slow pole, about 1/30 s
  EXPECT_GT(std::abs(after_a_while.pitch()), 0.02);
  EXPECT_LT(std::abs(later.pitch()), 1e-3);
  EXPECT_NEAR(later.bias.x, bias.x, 1e-3);
  EXPECT_NEAR(later.bias.y, bias.y, 1e-3);
}

TEST(AttitudeFilter, LearnsItAtOnceWhileItStandsStill) {
  AttitudeFilter filter;
  for (double t = 0; t < 3; t += dt) filter.follow(dt, {0.1, 0.2, -0.3}, {0, 0, g}, g, {}, true);
  EXPECT_NEAR(norm(filter.bias - Vec3d{0.1, 0.2, -0.3}), 0, 2e-3);  // e^-6 of it
}

/// A walk shakes its sensor: forward in time with the steps, and hard downward when a foot lands, while it leans. The mean of both is
/// zero, but that of the direction of what an accelerometer shows is not.
TEST(AttitudeFilter, IsNotMisledByFootfallsInStepWithAcceleration) {
  const auto R = [](double) { return Mat3d{}; };
  const auto shaken = [](double t) {
    const double phase = 2 * pi * 4 * t;  // [rad] four steps a second
    return Vec3d{4 * std::cos(phase), 0, 8 * std::cos(phase)};
  };
  const AttitudeFilter filter = follow(40, R, no_acceleration, shaken, {});
  // The remainder is the ripple of one step: a/(g T 2 pi f)
  EXPECT_LT(std::abs(filter.pitch()), 2 * 4 / (g * 3 * 2 * pi * 4));
  // The mean direction of the same force leans by much more: the limit of a filter of unit vectors
  double forward = 0, count = 0;
  for (double t = 0; t < 0.25; t += 1e-4, ++count) {
    const Vec3d force = shaken(t) + Vec3d{0, 0, g};
    forward += force.x / norm(force);
  }
  EXPECT_GT(std::abs(forward / count), 0.05);
}

}  // namespace
}  // namespace murosimf::locomotion
