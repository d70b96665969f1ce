// Numbers of MJCF files that symmetric robots do not show: gears, ranges with unequal ends, anchors, directions downwards.
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

/// The servo of an arm with its hinge beside its body's origin.
Servo servo(const std::string& joint, const std::string& actuator) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = fixtures::temp_folder() / (std::string("mjcf_numbers_") + test->name() + ".xml");
  std::ofstream(file) << R"(<mujoco model="odd"><compiler angle="radian" autolimits="true"/><worldbody>
<body name="base"><freejoint/><geom type="sphere" size="0.1" mass="1"/>
<body name="arm" pos="0 0 0.3"><inertial pos="0.2 0.7 0" mass="2" diaginertia="0.01 0.02 0.03"/>
<joint name="hinge" axis="0 1 0" pos="0.1 0 -0.05" armature="0.004" )"
                      << joint << "/></body></body></worldbody>\n<actuator>" << actuator << "</actuator></mujoco>\n";
  const auto model = robot::read_robot(file).model;
  return *model->find(properties::servo, model->object_index("hinge"));
}

TEST(MjcfNumbers, GearTurnsForcesAndGainsOfTheActuatorIntoThoseOfTheJoint) {
  for (const std::string gear : {"3", "-3"}) {
    const Servo found = servo("", "<position joint='hinge' gear='" + gear + "' kp='10' kv='0.5' forcerange='-2 5'/>");
    EXPECT_DOUBLE_EQ(found.stall_torque, 15);
    EXPECT_DOUBLE_EQ(found.position_gain, 90);
    EXPECT_DOUBLE_EQ(found.velocity_gain, 4.5);
  }
  EXPECT_DOUBLE_EQ(servo("", "<position joint='hinge' gear='2' kp='1' forcerange='-7 5'/>").stall_torque, 14);
  EXPECT_DOUBLE_EQ(servo("", "<motor joint='hinge' gear='2' ctrlrange='-1 4'/>").stall_torque, 8);
  EXPECT_DOUBLE_EQ(servo("", "<motor joint='hinge' gear='2' ctrlrange='-6 4'/>").stall_torque, 12);
}

TEST(MjcfNumbers, JointLimitsTheEffortByItsFartherEnd) {
  const std::string actuator = "<position joint='hinge' gear='3' kp='10' forcerange='-4 4'/>";
  EXPECT_DOUBLE_EQ(servo("actuatorfrcrange='-8 3'", actuator).stall_torque, 8);
  EXPECT_DOUBLE_EQ(servo("actuatorfrcrange='-3 8'", actuator).stall_torque, 8);
  EXPECT_DOUBLE_EQ(servo("actuatorfrcrange='-30 20'", actuator).stall_torque, 12);
  EXPECT_DOUBLE_EQ(servo("actuatorfrcrange='-3 8'", "<position joint='hinge' kp='10'/>").stall_torque, 8);
}

// J about the hinge at (0.1, 0, -0.05): 0.02 + 2 kg (0.1^2 + 0.05^2), and the armature.
TEST(MjcfNumbers, DampingRatioCountsTheInertiaAboutTheAnchor) {
  const double J = 0.004 + 0.02 + 2 * (0.1 * 0.1 + 0.05 * 0.05);
  EXPECT_NEAR(servo("", "<position joint='hinge' gear='3' kp='10' dampratio='0.4'/>").velocity_gain,
              2 * 0.4 * std::sqrt(90 * J), 1e-9);
}

TEST(MjcfNumbers, ZAxisMayPointAnywhere) {
  for (const Vec3d& axis :
       {Vec3d{0.6, 0, 0.8}, {0.6, 0, -0.8}, {-0.48, 0.6, -0.64}, {0, 2, 0}, {0, 0, -1}, {0, 0, 3}}) {
    const Mat3d turn = turn_of_z(axis);
    EXPECT_LT(fixtures::difference(turn.z, (1 / norm(axis)) * axis), 1e-12) << axis.x << " " << axis.z;
    EXPECT_LT(fixtures::difference(turn * transpose(turn), Mat3d{}), 1e-12);
    const Vec3d across = cross(Vec3d{0, 0, 1}, axis);
    EXPECT_LT(fixtures::difference(turn * across, across), 1e-12) << "the shortest way there";
  }
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
