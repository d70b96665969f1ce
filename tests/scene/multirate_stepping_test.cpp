// Robots with steps of their own length: alone they take these, in company those of the scene.
#include "murosimf/collision/multirate_stepping.h"

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/scene/scene_hashes.h"
#include "tests/written_scene.h"

namespace murosimf::scene {
namespace {

using namespace std::chrono_literals;
using fixtures::error_of;
using fixtures::says;

std::string walker(const std::string& level, const std::string& about_scene, const std::string& about_robot = "") {
  return fixtures::write_scene(about_scene + R"(
[defaults]
command = [0.1, 0, 0.1]
[[robots]]
name = "blue1"
model = "kid21"
controller = "walk"
sensors = false
level = ")" + level + "\"\n" + about_robot);
}

const std::string ball_that_comes = R"(
[ball]
position = [2, 0.03]
velocity = [-3, 0, 0]
)";

double ratio_of(Scene& scene, const std::string& robot = "blue1") {
  return scene.simulation().world().entity(robot).base().get(properties::step_ratio);
}

/// Of all objects that have a row of their own.
std::vector<Vec3d> positions_of(Scene& scene) {
  Entity& robot = scene.simulation().world().entity("blue1");
  std::vector<Vec3d> positions;
  for (const Object& object : robot.model().objects()) {
    if (!object.structural) positions.push_back(robot.object(object.name).get(properties::position));
  }
  return positions;
}

std::vector<double> joints_of(Scene& scene) {
  Entity& robot = scene.simulation().world().entity("blue1");
  std::vector<double> joints;
  for (const int joint : robot.model().joints()) {
    joints.push_back(
        robot.object(robot.model().objects()[static_cast<std::size_t>(joint)].name).get(properties::joint_position));
  }
  return joints;
}

class MultirateSteppingAtLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, MultirateSteppingAtLevel,
                         testing::Values("kinematic_walking", "simplified_dynamics", "full_dynamics",
                                         "articulated_dynamics"),
                         [](const auto& info) { return info.param; });

// Law: 5 ms are 5 ms, whatever else steps at 1 ms, to the last bit.
TEST_P(MultirateSteppingAtLevel, AloneARobotMovesAsInASceneOfItsRate) {
  Scene mixed(walker(GetParam(), ball_that_comes, "rate = 200\nposition = [0, 30]\n"));
  Scene slow(walker(GetParam(), "rate = 200\n", "position = [0, 30]\n"));
  mixed.simulation().run(2s);
  slow.simulation().run(2s);
  EXPECT_EQ(ratio_of(mixed), 5);
  const auto positions = positions_of(mixed), expected = positions_of(slow);
  for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(norm(positions[i] - expected[i]), 0) << i;
  EXPECT_EQ(joints_of(mixed), joints_of(slow));
  EXPECT_GT(norm(positions[0] - Vec3d{0, 30, positions[0].z}), 0.02) << "it walks";
}

// A ball at 3 m/s comes from 2 m, is stopped by the robot and lies at its feet.
TEST_P(MultirateSteppingAtLevel, InCompanyItTakesTheStepsOfTheScene) {
  Scene scene(walker(GetParam(), ball_that_comes, "rate = 200\ncommand = [0, 0, 0]\n"));
  Scene all_fine(walker(GetParam(), ball_that_comes, "command = [0, 0, 0]\n"));
  scene.simulation().run(100ms);
  EXPECT_EQ(ratio_of(scene), 5);
  scene.simulation().run(900ms);
  all_fine.simulation().run(1000ms);
  EXPECT_EQ(ratio_of(scene), 1);
  const auto ball = [](Scene& s) { return s.simulation().world().entity("ball").base().get(properties::position); };
  EXPECT_GT(ball(scene).x, 0) << "it did not pass through";
  EXPECT_LT(norm(ball(scene) - ball(all_fine)), 0.05);
}

TEST_P(MultirateSteppingAtLevel, AreTheSameWithThreadsAfterAResetAndFromAState) {
  const std::string file = walker(GetParam(), ball_that_comes, "rate = 200\n");
  Scene one(file), three(file, {.threads = 3});
  one.simulation().run(403ms);  // within a long step
  const auto state = one.save();
  one.simulation().run(400ms);
  three.simulation().run(803ms);
  const auto hash = one.simulation().state_hash();
  EXPECT_EQ(three.simulation().state_hash(), hash);
  three.load(state);
  three.simulation().run(400ms);
  EXPECT_EQ(three.simulation().state_hash(), hash);
  one.reset();
  one.simulation().run(803ms);
  EXPECT_EQ(one.simulation().state_hash(), hash);
}

TEST(MultirateStepping, WhoComesNearIsNoticedInTime) {
  Scene scene(walker("articulated_dynamics", ball_that_comes, "rate = 200\ncommand = [0, 0, 0]\n"));
  Entity& robot = scene.simulation().world().entity("blue1");
  Entity& ball = scene.simulation().world().entity("ball");
  bool was_alone = false;
  for (int i = 0; i < 1200; ++i) {
    scene.simulation().step();
    const double away = norm(ball.base().get(properties::position) - robot.base().get(properties::position));
    if (ratio_of(scene) > 1) {
      was_alone = true;
      EXPECT_GT(away, 0.3) << i << ": robots that step alone must be too far apart to touch";
    }
  }
  EXPECT_TRUE(was_alone);
}

TEST(MultirateStepping, MistakesAreRefusedInOneLine) {
  EXPECT_TRUE(says(error_of([] { Scene(walker("full_dynamics", "", "rate = 300\n")); }),
                   {".toml:", "'blue1'", "300 Hz", "1000 Hz", "no whole multiple"}));
  EXPECT_TRUE(says(error_of([] { Scene(walker("full_dynamics", "", "rate = 2000\n")); }), {"no whole multiple"}));
  EXPECT_TRUE(says(error_of([] { Scene(walker("full_dynamics", "", "rate = 200\nself_collision = true\n")); }),
                   {"'blue1'", "self_collision"}));
}

TEST(MultirateStepping, NobodyHasThemUnasked) {
  Scene scene(walker("full_dynamics", "", "rate = 1000\n"));
  scene.simulation().run(10ms);
  EXPECT_EQ(scene.simulation().world().entity("blue1").find(properties::step_ratio), nullptr);
}

TEST(ControlRate, IsThatOfTheController) {
  Scene scene(walker("full_dynamics", "", "control_rate = 40\n"));
  scene.simulation().run(1s);
  for (const AlgorithmStatistics& row : scene.simulation().statistics()) {
    if (row.name != "walk_engine") continue;
    EXPECT_EQ(row.rate_hz, 40);
    EXPECT_EQ(row.calls, 40);
  }
}

}  // namespace
}  // namespace murosimf::scene
