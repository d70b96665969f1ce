// The kick that sends a ball in a direction, its place, and the path there; closed forms and steps of the path.
#include "murosimf/locomotion/kick_plan.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/math/scalar.h"

namespace murosimf::locomotion {
namespace {

const Vec3d fastest{0.4, 0.15, 1};
/// Forward with either foot, and to the left.
const std::vector<KickChoice> kicks{{3, {{0.2, 0.05, 0}, 0}}, {5, {{0.2, -0.05, 0}, 0}}, {8, {{0, 0.25, 0}, pi / 2}}};

/// The direction [rad] in which the plan's kick sends the ball, and the place [m] of the ball before it, from the robot's present place.
struct Outcome {
  double direction = 0;
  Vec3d ball;
};
Outcome outcome(const KickPlan& plan) {
  for (const auto& [motion, kick] : kicks) {
    if (motion != plan.motion) continue;
    const Vec3d ball = from_there(plan.place, kick.ball);
    return {plan.place.z + kick.direction, {ball.x, ball.y, 0}};
  }
  return {};
}

TEST(KickPlan, SendsTheBallInTheDirectionFromWhereItLies) {
  for (const double direction : {-3.0, -1.0, -0.3, 0.0, 0.5, 1.5, 2.5}) {
    for (const Vec3d& ball : {Vec3d{0.2, 0.05, 0}, Vec3d{0.4, -0.3, 0}, Vec3d{-0.3, 0.1, 0}}) {
      const auto plan = plan_kick(kicks, {.direction = direction, .ball_x = ball.x, .ball_y = ball.y}, fastest);
      ASSERT_TRUE(plan);
      const Outcome found = outcome(*plan);
      EXPECT_NEAR(std::remainder(found.direction - direction, 2 * pi), 0, 1e-12);
      EXPECT_NEAR(norm(found.ball - ball), 0, 1e-12) << direction;
    }
  }
}

TEST(KickPlan, TakesTheKickThatIsNearest) {
  const auto motion = [](double direction, double side, const Vec3d& ball) {
    return plan_kick(kicks, {.direction = direction, .side = side, .ball_x = ball.x, .ball_y = ball.y}, fastest)
        ->motion;
  };
  EXPECT_EQ(motion(0, 0, {0.2, 0.05, 0}), 3);
  EXPECT_EQ(motion(0, 0, {0.2, -0.05, 0}), 5);
  EXPECT_EQ(motion(0, 1, {0.2, -0.05, 0}), 3) << "the side counts";
  EXPECT_EQ(motion(0, -1, {0.2, 0.05, 0}), 5);
  EXPECT_EQ(motion(pi / 2, 0, {0, 0.25, 0}), 8) << "sideways";
  EXPECT_NE(motion(pi / 2, 0, {0.2, 0.05, 0}), 8) << "only where the ball lies beside the robot";
  EXPECT_EQ(motion(-pi / 2, -1, {0.2, -0.05, 0}), 5) << "and turns where it has no kick to that side";
}

TEST(KickPlan, TurnsOnTheSpotWhereItDoesNotKnowWhereTheBallLies) {
  const auto plan = plan_kick(kicks, {.direction = 0.5, .side = -1}, fastest);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->motion, 5);
  EXPECT_EQ(plan->place.x, 0);
  EXPECT_EQ(plan->place.y, 0);
  EXPECT_DOUBLE_EQ(plan->place.z, 0.5);
}

TEST(KickPlan, IsNothingWithoutAKickOfThatSide) {
  EXPECT_FALSE(plan_kick({kicks[2]}, {.side = -1}, fastest));
  EXPECT_FALSE(plan_kick({}, {}, fastest));
}

// A point robot that follows the velocity arrives, and is never nearer to the ball than at the start or as requested.
TEST(KickPlan, WalksRoundTheBall) {
  constexpr double clearance = 0.18, dt = 0.01;
  for (const double direction : {-3.1, -2.0, -1.0, 0.0, 1.0, 2.0, 3.1}) {
    const Vec3d ball{0.3, 0.02, 0};
    const auto plan = plan_kick(kicks, {.direction = direction, .ball_x = ball.x, .ball_y = ball.y}, fastest);
    Vec3d place;
    double nearest = 1;
    for (int i = 0; i < 2000; ++i) {
      const Vec3d v = velocity_to_kick(seen_from(place, plan->place), seen_from(place, ball), clearance, fastest);
      EXPECT_LE(std::abs(v.x), fastest.x);
      EXPECT_LE(std::abs(v.y), fastest.y);
      EXPECT_LE(std::abs(v.z), fastest.z);
      place = from_there(place, dt * v);
      nearest = std::min(nearest, std::hypot(place.x - ball.x, place.y - ball.y));
    }
    const Vec3d left = seen_from(place, plan->place);
    EXPECT_LT(std::hypot(left.x, left.y), 0.01) << direction;
    EXPECT_LT(std::abs(left.z), 0.01) << direction;
    EXPECT_GT(nearest, clearance - 0.02) << direction;
  }
}

}  // namespace
}  // namespace murosimf::locomotion
