#include "murosimf/multibody/integrate.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/law.h"

namespace murosimf::multibody {
namespace {

using fixtures::difference;

double length(const Quaterniond& q) { return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }

// Advanced in its own frame the ball would gain w^2 dt / 2 of its speed per second (here 0.2 m/s in 10 s).
TEST(Integrate, RollingBallKeepsItsVelocity) {
  FreeBody<double> ball;
  ball.velocity = {1, 0.1, 0};
  ball.rate = {-2, 20, 0.5};
  for (int i = 0; i < 10000; ++i) advance<double>(ball, {}, 1e-3);
  law::expect_equal({.law = "rolling ball without forces: change of velocity in 10 s",
                     .level = "integration",
                     .source = "momentum stays, bit for bit, however fast it turns"},
                    difference(ball.velocity, {1, 0.1, 0}), 0, "m/s");
  EXPECT_EQ(difference(ball.rate, {-2, 20, 0.5}), 0);
  // 1e4 additions of numbers up to 10 m, 1e-15 each
  law::expect_below({.law = "rolling ball without forces: error of the way in 10 s",
                     .level = "integration",
                     .source = "v t"},
                    difference(ball.position, {10, 1, 0}), 1e-11, "m");
}

// The exponential map is exact for any step, on the world's side of the first orientation. Tolerance: rounding of n
// products of quaternions.
TEST(Integrate, ConstantRateIsExact) {
  const Quaterniond start = normalized(Quaterniond{0.5, -0.2, 0.3, 0.8});
  const Vec3d rate{0.3, -1.1, 2.0};
  for (const double dt : {1e-3, 1e-2, 0.5}) {
    FreeBody<double> body;
    body.turn = start;
    body.rate = rate;
    const int steps = 1000;
    for (int i = 0; i < steps; ++i) advance<double>(body, {}, dt);
    const Mat3d expected = to_matrix(exponential((steps * dt) * rate)) * to_matrix(start);
    law::expect_below({.law = fmt::format("constant rate: error of the orientation after 1000 steps of {} s", dt),
                       .level = "integration",
                       .source = "exp(w t)"},
                      difference(to_matrix(body.turn), expected), steps * (1e-15 + 1e-16 * dt), "");
  }
}

// Without normalizing it drifts by some 1e-13. Tolerance: rounding of one normalization.
TEST(Integrate, QuaternionKeepsItsLength) {
  fixtures::Dice dice("quaternion length");
  FreeBody<double> body;
  law::Worst error;
  for (int i = 0; i < 100000; ++i) {
    body.rate = dice.vector(20);
    advance<double>(body, {}, 1e-3);
    if (i % 1000 == 0) error.see(std::abs(length(body.turn) - 1), "step", i);
  }
  error.see(std::abs(length(body.turn) - 1), "end");
  law::expect_below({.law = "quaternion's length in 1e5 steps: error", .level = "integration", .source = "it is 1"},
                    error, 4e-16, "");
}

// The explicit method gives n (n - 1) / 2. Tolerance: n additions.
TEST(Integrate, ConstantAccelerationInClosedForm) {
  FreeBody<double> body;
  const double dt = 1e-3;
  const int n = 1000;
  const Twistd acceleration{{0, 0, 3}, {1, -2, -9.81}};
  for (int i = 0; i < n; ++i) advance<double>(body, acceleration, dt);
  const double area = dt * dt * n * (n + 1) / 2;
  const std::string first = "n dt a", second = "semi-implicit Euler: dt^2 a n (n + 1) / 2";
  const auto expect_small = [](const std::string& of, const std::string& source, double error, const char* unit) {
    law::expect_below({.law = "constant acceleration: error of the " + of + " after 1 s",
                       .level = "integration",
                       .source = source},
                      error, 1e-12, unit);
  };
  expect_small("velocity", first, difference(body.velocity, (n * dt) * acceleration.v), "m/s");
  expect_small("way", second, difference(body.position, area * acceleration.v), "m");
  expect_small("rate", first, difference(body.rate, (n * dt) * acceleration.w), "rad/s");
  expect_small("angle, axis fixed", second, difference(rotation_vector(body.turn), area * acceleration.w), "rad");
}

TEST(Integrate, RestIsRest) {
  FreeBody<double> body;
  body.position = {0.1, 0.2, 0.3};
  body.turn = normalized(Quaterniond{1, 2, 3, 4});
  const Quaterniond start = normalized(body.turn);
  for (int i = 0; i < 1000; ++i) advance<double>(body, {}, 1e-3);
  law::expect_equal({.law = "rest without forces: change of the place in 1 s",
                     .level = "integration",
                     .source = "rest is rest, bit for bit"},
                    difference(body.position, {0.1, 0.2, 0.3}), 0, "m");
  EXPECT_NEAR(body.turn.w, start.w, 2e-16);
  EXPECT_NEAR(body.turn.z, start.z, 2e-16);
}

}  // namespace
}  // namespace murosimf::multibody
