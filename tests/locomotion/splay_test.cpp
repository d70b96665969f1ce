// Legs that turn outward only: both feet point outward in a turn, and the robot turns as it is told.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/scene/scene.h"

namespace murosimf::locomotion {
namespace {

using namespace std::chrono_literals;

ModelPtr of_program(const std::string& name) {
  return robot::read_robot(files::find_data_file(name, "models", ".xml"), {}).model;
}

TEST(Splay, IsOfLegsThatTurnOutwardOnly) {
  EXPECT_EQ(seeded_parameters(*of_program("spark_nao0")).splay, 1);
  for (const char* model : {"kid21", "booster_k1", "booster_t1", "unitree_g1"})
    EXPECT_EQ(seeded_parameters(*of_program(model)).splay, 0) << model;
}

TEST(Splay, GivenIsTaken) { EXPECT_EQ(walk_parameters(*of_program("spark_nao0"), {{"splay", 0.5}}).splay, 0.5); }

TEST(Splay, LeavesTheFastestTurnAsItIs) {
  const ModelPtr nao = of_program("spark_nao0");
  EXPECT_EQ(seeded_parameters(*nao).fastest.z, WalkParameters{}.fastest.z);
  EXPECT_LT(walk_parameters(*nao, {{"splay", 0.0}}).fastest.z, 0.5 * WalkParameters{}.fastest.z);
}

/// Both soles at every phase of a turn to the left or right, from the middle outward. [rad]
TEST(Splay, TurnsNoFootInward) {
  const ModelPtr nao = of_program("spark_nao0");
  const auto& legs = legs_of(*nao);
  const WalkParameters p = seeded_parameters(*nao);
  for (const double turn : {-0.6, 0.6}) {
    double most = 0, between = 0;
    for (double phase = 0; phase < 2 * pi; phase += 0.05) {
      const GaitFeet feet = gait_feet(legs, p, phase, 1, {0, 0, turn});
      const double left = std::atan2(feet.sole[0].x.y, feet.sole[0].x.x);
      const double right = -std::atan2(feet.sole[1].x.y, feet.sole[1].x.x);
      EXPECT_GT(std::min(left, right), -1e-6) << phase;
      most = std::max(most, std::max(left, right));
      between = std::max(between, std::abs(left - right));
      EXPECT_TRUE(gait_pose(legs, p, phase, 1, {0, 0, turn}).reachable) << phase;
    }
    // As far outward as the stride turns; a hinge that turns both legs alike, as that of a real Nao, would do.
    EXPECT_NEAR(most, 0.6 * p.period / 2, 0.01);
    EXPECT_LT(between, 0.02);
  }
}

/// [rad] that a robot told to turn does so in `time` [s], after a second.
double turned(const std::string& model, const std::string& controller, const std::string& level, double rate,
              int time) {
  scene::Scene scene("walk",
                     {.overrides = {"walker.model=" + model, "walker.controller=" + controller, "walker.level=" + level,
                                    "walker.command=[0,0," + std::to_string(rate) + "]"},
                      .cameras = false});
  scene.simulation().run(1s);
  Entity& robot = scene.simulation().world().entity("walker");
  const auto heading = [&] {
    const Mat3d R = robot.base().get(properties::orientation);
    return std::atan2(R.x.y, R.x.x);
  };
  double sum = 0, before = heading();
  for (int i = 0; i < 4 * time; ++i) {
    scene.simulation().run(250ms);
    const double now = heading();
    sum += std::remainder(now - before, 2 * pi);
    before = now;
  }
  return sum;
}

TEST(Splay, TurnsTheRobotAsItIsTold) {
  // The feet of type 3, with the longest legs, slide in an open-loop turn at full_dynamics.
  for (const auto& [model, controller] :
       {std::pair{"spark_nao0", "walk"}, std::pair{"spark_nao0", "motions"}, std::pair{"spark_nao3", "motions"}}) {
    for (const char* level : {"kinematic_walking", "simplified_dynamics", "full_dynamics", "articulated_dynamics"}) {
      for (const double rate : {0.5, -0.5})
        EXPECT_NEAR(turned(model, controller, level, rate, 7) / (7 * rate), 1, 0.15)
            << model << ", " << controller << ", " << level << ", " << rate;
    }
  }
}

// With a table of another type's steps it walked backward.
TEST(Splay, TheTypeWithToesWalksForward) {
  for (const char* level : {"simplified_dynamics", "full_dynamics", "articulated_dynamics"}) {
    scene::Scene scene("walk", {.overrides = {"walker.model=spark_nao4", "walker.controller=motions",
                                              std::string("walker.level=") + level, "walker.command=[0.1,0,0]",
                                              "walker.position=[0,0]"},
                                .cameras = false});
    scene.simulation().run(8s);
    EXPECT_NEAR(scene.simulation().world().entity("walker").base().get(properties::position).x, 0.74, 0.15) << level;
  }
}

}  // namespace
}  // namespace murosimf::locomotion
