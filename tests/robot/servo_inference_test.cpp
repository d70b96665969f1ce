// Guessed servos, against the rule computed by hand from the robot's mass and the height of its center.
#include "murosimf/robot/servo_inference.h"

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/biped_urdf.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using robot_formats::urdf::urdf_files::any_contains;
using robot_formats::urdf::urdf_files::write;

RobotFile read(const fixtures::Biped& biped) { return read_robot(write("biped.urdf", fixtures::biped_urdf(biped))); }

const Servo& servo(const RobotFile& robot, const std::string& joint) {
  return *robot.model->find(properties::servo, robot.model->object_index(joint));
}

/// [N m/rad] m g z_c of fixtures::Biped at size 1, by hand: the feet end at -0.895 m.
double topples() {
  const double leg = 2 * 1.2 * 0 + 7 * -0.22 + 4 * (-0.41 - 0.2) + 0.5 * -0.82 + 1.3 * (-0.82 - 0.06);
  const double mass = 26 + 6.5 + 2 * (2 * 1.2 + 7 + 4 + 0.5 + 1.3);
  return 9.81 * (26 * 0.3 + 2 * leg + mass * 0.895);
}

TEST(ServoInference, ABipedsServosAreStifferThanItTopples) {
  const RobotFile robot = read({.torque = 180, .ankle = 20});
  EXPECT_NEAR(servo(robot, "r_knee").position_gain, 4 * 180 / 0.1, 1e-6) << "all torque at a quarter of 0.1 rad";
  EXPECT_NEAR(servo(robot, "r_ankle_pitch").position_gain, 4 * topples(), 1e-6) << "in a leg at least this";
  EXPECT_NEAR(servo(robot, "r_ankle_pitch").velocity_gain, 0.025 * 4 * topples(), 1e-6);
  EXPECT_EQ(servo(robot, "r_ankle_pitch").stall_torque, 20);
  EXPECT_TRUE(any_contains(robot.notes, "guessed: position gains of 13 servos, all torque at 0.025 rad"));
}

TEST(ServoInference, NoTorqueIsAbsurd) {
  const RobotFile robot = read({.effort = "50000"});
  EXPECT_NEAR(servo(robot, "l_knee").stall_torque, 10 * topples(), 1e-6);
  EXPECT_NEAR(servo(robot, "l_knee").position_gain, 40 * topples(), 1e-6);
  EXPECT_TRUE(any_contains(robot.notes, "'l_knee' 50000"));
  EXPECT_FALSE(any_contains(read({}).notes, "no joint of this robot needs"));
}

TEST(ServoInference, ALegsJointWithoutTorqueGetsAWholeServo) {
  const RobotFile robot = read({.effort = "0"});
  EXPECT_NEAR(servo(robot, "l_knee").stall_torque, 0.4 * topples(), 1e-6);
  EXPECT_NEAR(servo(robot, "l_knee").position_gain, 4 * topples(), 1e-6);
  const double* rotor = robot.model->find(properties::joint_armature, robot.model->object_index("l_knee"));
  ASSERT_TRUE(rotor);
  const double mass = robot.model->tree().mass, height = topples() / (9.81 * mass);
  EXPECT_NEAR(*rotor, 0.005 * mass * height * height, 1e-9);
  EXPECT_TRUE(any_contains(robot.notes, "1 servos in the legs of which the file says nothing"));
}

// An arm on a table has no soles: it does not topple.
TEST(ServoInference, WithoutTwoSolesAllTorqueIsAtATenthOfARadian) {
  const RobotFile robot = read_robot(write(
      "arm.urdf",
      "<robot name='arm'><link name='base'/><link name='arm'><inertial><mass value='1'/><inertia ixx='0.1' iyy='0.1' "
      "izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='shoulder' type='revolute'><parent "
      "link='base'/><child link='arm'/><axis xyz='0 1 0'/><limit lower='-1' upper='1' effort='5' "
      "velocity='3'/></joint></robot>"));
  EXPECT_NEAR(servo(robot, "shoulder").position_gain, 50, 1e-9);
  EXPECT_NEAR(servo(robot, "shoulder").velocity_gain, 0.05 * 50, 1e-9);
}

std::string turntable(const std::string& base_inertia) {
  const auto solid = [](const std::string& inertia) {
    return "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='" + inertia + "'/></inertial>";
  };
  return "<robot name='r'><link name='base'>" + solid(base_inertia) + "</link><link name='arm'>" + solid("1e-4") +
         "</link><joint name='j' type='continuous'><parent link='base'/><child link='arm'/><axis xyz='0 0 1'/><limit "
         "effort='5' velocity='3'/></joint></robot>";
}

// Two bodies that turn freely about one axis against each other: I = I1 I2 / (I1 + I2) = 0.75e-4 kg m^2, and 5 N m / 0.1 rad is more
// than I / (2 ms)^2.
TEST(ServoInference, NoJointIsStifferThanWhatItMovesAllows) {
  const RobotFile robot = read_robot(write("light.urdf", turntable("3e-4")));
  EXPECT_NEAR(servo(robot, "j").position_gain, 0.75e-4 / 4e-6, 1e-9);
  EXPECT_NEAR(servo(robot, "j").velocity_gain, 0.05 * 0.75e-4 / 4e-6, 1e-9);
  EXPECT_EQ(servo(robot, "j").stall_torque, 5);
  EXPECT_TRUE(any_contains(robot.notes, "guessed: 1 of these gains"));
}

}  // namespace
}  // namespace murosimf::robot
