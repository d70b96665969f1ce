// A player that kicks: the ball flies towards the goal, and a player that falls gets up again.
#include "murosimf/soccer/ball_chaser.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"

namespace murosimf::soccer {
namespace {

constexpr double half_length = 3;  // [m] of the field of scene `duel`

struct Played {
  Vec3d ball;       // [m] where it is at the end
  int motions = 0;  // that the robot has begun
};

Played play(std::uint64_t seed, const std::string& model = "kid21") {
  scene::Scene scene("duel", {.seed = seed,
                              .overrides = {"*.options.kicks=true", "*.level=articulated_dynamics",
                                            "red1.present=false", "*.model=" + model},
                              .cameras = false});
  Entity& ball = scene.simulation().world().entity("ball");
  Entity& robot = scene.simulation().world().entity("blue1");
  double mode = 0;
  Played played;
  for (int i = 0; i < 400; ++i) {
    scene.simulation().run(std::chrono::milliseconds(100));
    const double before = std::exchange(mode, robot.base().get(properties::motion_state).mode);
    if (mode != before && mode != 0) ++played.motions;
    played.ball = ball.base().get(properties::position);
    if (played.ball.x > half_length) break;
  }
  return played;
}

TEST(BallChaser, KicksTheBallIntoTheGoal) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Played played = play(seed);
    EXPECT_GE(played.motions, 1) << seed;
    EXPECT_GT(played.ball.x, half_length) << seed;
    EXPECT_LT(std::abs(played.ball.y), 0.75) << seed;
  }
}

TEST(BallChaser, KicksAsAnyRobotWhoseMotionsSayWhereTheBallLies) {
  const Played played = play(1, "spark_nao0");
  EXPECT_GE(played.motions, 1);
  EXPECT_GT(played.ball.x, half_length);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { (void)play(1, "spark_nao3"); }),
                             {"'kicks': no motion of the robot's file says where it kicks a ball"}));
}

}  // namespace
}  // namespace murosimf::soccer
