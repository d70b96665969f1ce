// Robots of teams, from the files that they publish (tests/robot_data.h): they stand, walk and fall.
//
// The files name no soles and no gains, so both are guessed when they are read (murosimf/robot/role_inference.h). No rows of
// docs/validation.md come from here, because the files are no part of the project.
#include <gtest/gtest.h>

#include <map>

#include "murosimf/robot/robot_reader.h"
#include "tests/physics/stand.h"
#include "tests/robot_data.h"

namespace murosimf::test {
namespace {

struct RealRobot {
  std::string name;
  std::filesystem::path (*file)();
};
void PrintTo(const RealRobot& robot, std::ostream* stream) { *stream << robot.name; }

std::vector<RealRobot> real_robots() { return {{"K1", k1_mjcf}, {"Wolfgang_OP", wolfgang_urdf}}; }

ModelPtr model_of(const RealRobot& robot) {
  static std::map<std::string, ModelPtr> read;
  ModelPtr& model = read[robot.name];
  if (!model) model = robot::read_robot(robot.file()).model;
  return model;
}

class RealRobots : public testing::TestWithParam<RealRobot> {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_regular_file(GetParam().file())) {
      GTEST_SKIP() << "no " << GetParam().file() << "; MUROSIMF_TEST_DATA names another folder";
    }
  }
};
std::string robot_name(const testing::TestParamInfo<RealRobot>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Robots, RealRobots, testing::ValuesIn(real_robots()), robot_name);

TEST_P(RealRobots, StandAtEveryDynamicLevel) {
  for (const std::string& level : dynamic_levels()) {
    const StandStill stand = stand_still(model_of(GetParam()), level);
    EXPECT_LT(stand.moved, 3) << level;
    EXPECT_LT(stand.leaned, 1) << level;
  }
}

TEST_P(RealRobots, WalkTwoMetersOnKinematicFeet) {
  const Walk result = walk_two_meters(model_of(GetParam()));
  EXPECT_GT(result.moved.x, 2);
  EXPECT_LT(result.moved.x, 2.25);
  EXPECT_LT(std::abs(result.moved.y), 0.1);
  EXPECT_LT(result.slip, 0.0025) << "the standing sole is fixed, but for what it moves while it stops";
}

TEST_P(RealRobots, WalkAtEveryDynamicLevel) {
  for (const std::string& level : dynamic_levels()) {
    const Walk result =
        walk({.dynamics = {.level = level}, .command = {0.1, 0, 0}, .seconds = 10, .model = model_of(GetParam())});
    EXPECT_LT(result.lean, 20) << level << ": it falls";
    EXPECT_GT(result.moved.x, 0.5) << level;  // Wolfgang-OP's knees are slow
    EXPECT_LT(result.moved.x, 1.4) << level;
  }
}

// Leaning by 25 degrees and 20 cm above the ground: it hits the ground, falls over and comes to rest on it.
TEST_P(RealRobots, FallOverWhenDropped) {
  Rig rig;
  Entity& robot =
      rig.add("robot", model_of(GetParam()), {.position = {0, 0, 0.2}, .attitude = rotation_y(25 * degree)});
  rig.simulation.attach<locomotion::WalkEngine>("walk_engine", robot, 100);
  rig.attach_motion(robot, {.level = "articulated_dynamics"});
  rig.run(0.001);
  const double height = Rig::place(robot).z;
  rig.run(5.0);
  ASSERT_FALSE(robot.frozen()) << *robot.frozen_reason();
  const double lean = std::acos(std::clamp(robot.base().get(properties::orientation).z.z, -1.0, 1.0)) / degree;
  EXPECT_GT(lean, 50);
  EXPECT_LT(Rig::place(robot).z, 0.5 * height);
  EXPECT_LT(norm(Rig::velocity(robot)), 0.05) << "it lies";
}

}  // namespace
}  // namespace murosimf::test
