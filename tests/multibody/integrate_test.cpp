#include "murosimf/multibody/integrate.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

using fixtures::difference;

double length(const Quaterniond& q) { return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }

// Law: momentum. A ball that rolls without forces keeps its velocity, bit for bit, however fast it turns; advanced in
// its own frame it would gain w^2 dt / 2 of its speed per second (here 0.2 m/s in 10 s).
TEST(Integrate, RollingBallKeepsItsVelocity) {
  FreeBody<double> ball;
  ball.velocity = {1, 0.1, 0};
  ball.rate = {-2, 20, 0.5};
  for (int i = 0; i < 10000; ++i) advance<double>(ball, {}, 1e-3);
  EXPECT_EQ(difference(ball.velocity, {1, 0.1, 0}), 0);
  EXPECT_EQ(difference(ball.rate, {-2, 20, 0.5}), 0);
  EXPECT_LT(difference(ball.position, {10, 1, 0}), 1e-11);  // 1e4 additions of numbers up to 10 m, 1e-15 each
}

// Law: for a constant rate the exponential map is exact, for any step: the turn after t is exp(w t), on the world's
// side of the first orientation. Tolerance: rounding of n products of quaternions.
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
    EXPECT_LT(difference(to_matrix(body.turn), expected), steps * (1e-15 + 1e-16 * dt)) << dt;
  }
}

// Law: the quaternion's length is 1 after 1e5 steps; without normalizing it drifts by some 1e-13. Tolerance: rounding
// of one normalization.
TEST(Integrate, QuaternionKeepsItsLength) {
  fixtures::Dice dice("quaternion length");
  FreeBody<double> body;
  for (int i = 0; i < 100000; ++i) {
    body.rate = dice.vector(20);
    advance<double>(body, {}, 1e-3);
    if (i % 1000 == 0) {
      ASSERT_NEAR(length(body.turn), 1, 4e-16) << i;
    }
  }
  EXPECT_NEAR(length(body.turn), 1, 4e-16);
}

// Law: semi-implicit Euler in closed form: under constant acceleration v_n = n dt a, c_n = dt^2 a n (n + 1) / 2 (the
// explicit method gives n (n - 1) / 2). The same for the rate and, about a fixed axis, for the angle. Tolerance: n
// additions.
TEST(Integrate, ConstantAccelerationInClosedForm) {
  FreeBody<double> body;
  const double dt = 1e-3;
  const int n = 1000;
  const Motiond acceleration{{0, 0, 3}, {1, -2, -9.81}};
  for (int i = 0; i < n; ++i) advance<double>(body, acceleration, dt);
  const double area = dt * dt * n * (n + 1) / 2;
  EXPECT_LT(difference(body.velocity, (n * dt) * acceleration.v), 1e-12);
  EXPECT_LT(difference(body.position, area * acceleration.v), 1e-12);
  EXPECT_LT(difference(body.rate, (n * dt) * acceleration.w), 1e-12);
  EXPECT_LT(difference(rotation_vector(body.turn), area * acceleration.w), 1e-12);
}

// Law: a body at rest without forces stays, bit for bit.
TEST(Integrate, RestIsRest) {
  FreeBody<double> body;
  body.position = {0.1, 0.2, 0.3};
  body.turn = normalized(Quaterniond{1, 2, 3, 4});
  const Quaterniond start = normalized(body.turn);
  for (int i = 0; i < 1000; ++i) advance<double>(body, {}, 1e-3);
  EXPECT_EQ(difference(body.position, {0.1, 0.2, 0.3}), 0);
  EXPECT_NEAR(body.turn.w, start.w, 2e-16);
  EXPECT_NEAR(body.turn.z, start.z, 2e-16);
}

}  // namespace
}  // namespace murosimf::multibody
