#include "murosimf/league/robot_status.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace murosimf::league {
namespace {

constexpr double pi = std::numbers::pi;

/// Turned by `yaw`, then leaning forward by `pitch` [rad].
Mat3d axes(double yaw, double pitch = 0) {
  const double c = std::cos(yaw), s = std::sin(yaw), d = std::cos(pitch), e = std::sin(pitch);
  return {{c * d, s * d, -e}, {-s, c, 0}, {c * e, s * e, d}};
}

TEST(RobotStatus, IsTheTruthForTheTeamThatAttacksX) {
  const Vec3d ball{1, 3, 0.1};
  const RobotStatus status = status_of({.position = {1, 2, 0.3}, .axes = axes(pi / 2), .ball = &ball});
  EXPECT_DOUBLE_EQ(status.x, 1);
  EXPECT_DOUBLE_EQ(status.y, 2);
  EXPECT_DOUBLE_EQ(status.heading, pi / 2);
  EXPECT_FALSE(status.fallen);
  EXPECT_DOUBLE_EQ(status.ball_age, 0);
  EXPECT_NEAR(status.ball_x, 1, 1e-15);  // right ahead
  EXPECT_NEAR(status.ball_y, 0, 1e-15);
}

TEST(RobotStatus, OfTheOtherTeamIsTurnedByHalfATurnButForTheBall) {
  const Vec3d ball{0, 2, 0.1};
  const RobotStatus status = status_of({.position = {1, 2, 0.3}, .axes = axes(pi / 2), .ball = &ball, .attacks = -1});
  EXPECT_DOUBLE_EQ(status.x, -1);
  EXPECT_DOUBLE_EQ(status.y, -2);
  EXPECT_NEAR(status.heading, -pi / 2, 1e-15);
  EXPECT_NEAR(status.ball_x, 0, 1e-15);
  EXPECT_NEAR(status.ball_y, 1, 1e-15);  // to its left
}

TEST(RobotStatus, HasWhatTheRobotBelieves) {
  const Vec3d estimate{1.1, 2.1, 0.4};
  const RobotStatus status = status_of({.position = {1, 2, 0.3}, .axes = axes(0.5), .estimate = &estimate});
  EXPECT_DOUBLE_EQ(status.x, 1.1);
  EXPECT_DOUBLE_EQ(status.y, 2.1);
  EXPECT_DOUBLE_EQ(status.heading, 0.4);
  EXPECT_DOUBLE_EQ(status.ball_age, -1);  // there is none
}

TEST(RobotStatus, HasFallenBeyond60Degrees) {
  EXPECT_FALSE(status_of({.axes = axes(0, 59 * pi / 180)}).fallen);
  EXPECT_TRUE(status_of({.axes = axes(0, 61 * pi / 180)}).fallen);
  EXPECT_TRUE(status_of({.axes = axes(0, -90 * pi / 180)}).fallen);
}

}  // namespace
}  // namespace murosimf::league
