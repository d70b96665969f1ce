// Robots of teams, from the files that they publish (tests/robot_data.h): they stand, walk on kinematic feet, and fall.
//
// The files have no soles and no gains. Soles are the bottoms of their feet; gains are assumptions: every servo gives its
// largest torque at an error of 0.1 rad, and is damped by 2 % of its gain. No rows of docs/validation.md come from here,
// because the files are no part of the project.
#include <gtest/gtest.h>

#include <functional>

#include "murosimf/io/robot_builder.h"
#include "murosimf/io/robot_reader.h"
#include "tests/physics/stand.h"
#include "tests/robot_data.h"

namespace murosimf::test {
namespace {

/// A sole on a frame of the file, or below a body of it.
struct FootBottom {
  std::string on;
  io::Place place;  ///< in the frame of the body; not used if `on` is a frame
  Sole sole;
};

struct RealRobot {
  std::string name;
  std::function<std::filesystem::path()> file;
  std::vector<FootBottom> feet;
};
void PrintTo(const RealRobot& robot, std::ostream* stream) { *stream << robot.name; }

/// The K1's feet are boxes; the Wolfgang's stand on four cleats, 9 cm and 18.4 cm from each other.
std::vector<RealRobot> real_robots() {
  const Sole k1{0.09, 0.035}, wolfgang{0.092, 0.045};
  return {{"K1",
           k1_mjcf,
           {{"left_foot_link", {{0.026, 0, -0.038}, {}}, k1}, {"right_foot_link", {{0.026, 0, -0.038}, {}}, k1}}},
          {"Wolfgang_OP", wolfgang_urdf, {{"l_sole", {}, wolfgang}, {"r_sole", {}, wolfgang}}}};
}

void add_sole(io::RobotDraft& draft, const FootBottom& foot) {
  for (io::DraftBody& body : draft.bodies) {
    for (io::DraftFrame& frame : body.frames) {
      if (frame.name == foot.on) frame.box = foot.sole;
    }
    if (body.name == foot.on) body.frames.push_back({foot.on + "_sole", body.where, "site", foot.place, foot.sole});
  }
}

void add_gains(io::RobotDraft& draft) {
  for (io::DraftBody& body : draft.bodies) {
    for (io::DraftJoint& joint : body.joints) {
      const double torque =
          joint.servo && joint.servo->stall_torque > 0 ? joint.servo->stall_torque : joint.effort_limit;
      const double gain = torque / 0.1;
      joint.servo = Servo{.type = "assumed",
                          .law = "ideal_pd",
                          .stall_torque = torque,
                          .position_gain = gain,
                          .velocity_gain = 0.02 * gain,
                          .rotor_inertia = 0.02};
    }
  }
}

ModelPtr model_of(const RealRobot& robot) {
  static std::map<std::string, ModelPtr> read;
  ModelPtr& model = read[robot.name];
  if (model) return model;
  io::RobotDraft draft = io::read_robot(robot.file()).draft;
  for (const FootBottom& foot : robot.feet) add_sole(draft, foot);
  add_gains(draft);
  return model = io::build_model(draft, {});
}

class RealRobots : public testing::TestWithParam<RealRobot> {
 protected:
  void SetUp() override {
    if (!std::filesystem::is_regular_file(GetParam().file())) {
      GTEST_SKIP() << "no " << GetParam().file() << "; MUROSIMF_TEST_DATA names another folder";
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Robots, RealRobots, testing::ValuesIn(real_robots()),
                         [](const auto& info) { return info.param.name; });

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
  EXPECT_LT(result.slip, 1e-9) << "the standing sole is fixed to the plane";
}

// With the gains assumed here; servos that give way let them walk faster than told at articulated_dynamics.
TEST_P(RealRobots, WalkAtEveryDynamicLevel) {
  for (const std::string& level : dynamic_levels()) {
    const Walk result =
        walk({.dynamics = {.level = level}, .command = {0.1, 0, 0}, .seconds = 10, .model = model_of(GetParam())});
    EXPECT_LT(result.lean, 20) << level << ": it falls";
    EXPECT_GT(result.moved.x, 0.6) << level;
  }
}

// Leaning by 25 degrees and 20 cm above the ground: it hits the ground, falls over and comes to rest on it.
TEST_P(RealRobots, FallOverWhenDropped) {
  Rig rig;
  Entity& robot =
      rig.add("robot", model_of(GetParam()), {.position = {0, 0, 0.2}, .attitude = rotation_y(25 * degree)});
  rig.simulation.attach<control::WalkEngine>("walk_engine", robot, 100);
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
