/// robot_checks_test - every check finds its error, with its line, and reports nothing of a correct robot.
#include "murosimf/robot/robot_checks.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/robot/role_inference.h"
#include "tests/temp_folder.h"

namespace murosimf::robot {
namespace {

robot::RobotFile read(const std::string& bodies, const std::string& rest = "") {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file = fixtures::temp_folder() / (std::string("checks_") + test->name() + ".xml");
  std::ofstream(file)
      << "<mujoco model='r'><compiler angle='radian'/>\n<worldbody>\n<body name='trunk'><freejoint/>\n"
      << "<inertial pos='0 0 0' mass='1' diaginertia='.01 .01 .01'/><geom type='box' size='.1 .1 .1'/>\n"
      << bodies << "\n</body></worldbody>" << rest << "</mujoco>";
  return robot::read_robot(file);
}

/// A body with its joint, 1 m from the trunk.
std::string limb(const std::string& name, const std::string& y, const std::string& joint = "",
                 const std::string& inertial = "<inertial pos='0 0 0' mass='1' diaginertia='.01 .01 .01'/>") {
  return "<body name='" + name + "' pos='0 " + y + " 0'><joint name='j_" + name + "' axis='0 1 0' " + joint + "/>" +
         inertial + "<geom type='sphere' size='.1'/></body>\n";
}

std::vector<std::string> lines(const std::vector<Finding>& findings) {
  std::vector<std::string> lines;
  for (const Finding& finding : findings) lines.push_back(to_line(finding));
  return lines;
}

bool finds(const std::vector<Finding>& findings, const std::string& part) {
  return std::ranges::any_of(lines(findings), [&](const auto& l) { return l.find(part) != std::string::npos; });
}

TEST(RobotChecks, SaysNothingAboutASoundRobot) {
  const robot::RobotFile robot = robot::read_robot(std::filesystem::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml");
  for (const std::string& line : lines(examine(robot))) {
    if (line.find("the walk at") != std::string::npos) continue;  // its shins are too slow for it
    EXPECT_FALSE(line.starts_with("warning")) << line;
  }
}

/// kid21 with servos of its legs that turn with `rate` [rad/s] without load.
robot::RobotFile kid21_with_rate(const std::string& rate) {
  const auto folder = fixtures::temp_folder() / "kid21_rates";
  std::filesystem::create_directories(folder);
  const std::filesystem::path models = std::filesystem::path(MUROSIMF_SOURCE_DIR) / "models";
  std::filesystem::copy_file(models / "kid21.xml", folder / "kid21.xml",
                             std::filesystem::copy_options::overwrite_existing);
  std::ifstream in(models / "kid21.toml");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string speed = "no_load_speed = 6.6";
  text.replace(text.find(speed), speed.size(), "no_load_speed = " + rate);
  std::ofstream(folder / "kid21.toml") << text;
  return robot::read_robot(folder / "kid21.xml");
}

// The knee's rate is largest twice in a swing; a servo that is a little faster than that is fast enough, and with a slower one other
// joints reach their limits as well.
TEST(RobotChecks, NamesJointsThatTheWalkAsksForMoreThanTheirServosHave) {
  const auto findings = [](const std::string& rate) {
    const robot::RobotFile robot = kid21_with_rate(rate);
    return examine_gait(robot.description, *robot.model);
  };
  EXPECT_TRUE(
      finds(findings("6.6"), "the walk at 0.25 m/s asks 'j_l_shin' for up to 10.4 rad/s; its servo comes to 6.6"));
  EXPECT_TRUE(finds(findings("6.6"), ", also j_r_shin;"));
  EXPECT_TRUE(finds(findings("10.3"), "rad/s; its servo comes to 10.3"));
  EXPECT_TRUE(findings("10.5").empty());
  EXPECT_TRUE(finds(findings("3"), "j_l_thigh"));
}

TEST(RobotChecks, NamesTinyAndHugeBodiesAndTheirInertia) {
  const auto findings = [](const std::string& inertial) {
    return examine_masses(read(limb("arm", "1", "", inertial)).description);
  };
  EXPECT_TRUE(findings("<inertial pos='0 0 0' mass='1' diaginertia='.004 .004 .004'/>").empty());
  EXPECT_TRUE(finds(findings("<inertial pos='0 0 0' mass='2e-6' diaginertia='1e-9 1e-9 1e-9'/>"),
                    ":5: 'arm' moves and weighs only 2e-06 kg; "));
  EXPECT_TRUE(
      finds(findings("<inertial pos='0 0 0' mass='1e9' diaginertia='1e7 1e7 1e7'/>"), "the robot weighs 1e+09 kg"));
  EXPECT_TRUE(finds(findings("<inertial pos='0 0 0' mass='1' diaginertia='4 4 4'/>"), "is that of a body of 2 m"));
  EXPECT_TRUE(finds(findings("<inertial pos='0 0 0' mass='1' diaginertia='1e-9 1e-9 1e-9'/>"), "is that of a point"));
}

TEST(RobotChecks, NamesIdleJointsAndPlaceholders) {
  std::string arms;
  for (int i = 0; i < 6; ++i) arms += limb("arm" + std::to_string(i), std::to_string(i + 1), "range='-2.6 2.6'");
  const robot::RobotFile robot = read(arms);
  const auto findings = examine_joints(robot.description, *robot.model);
  EXPECT_TRUE(finds(findings, "no servo moves j_arm0, j_arm1, "));
  EXPECT_TRUE(finds(findings, ":5: 6 of 6 joints have the range -2.6 to 2.6: a placeholder?"));
  const robot::RobotFile wide = read(limb("arm", "1", "range='-4 4'"));
  EXPECT_TRUE(finds(examine_joints(wide.description, *wide.model), "from -4 to 4 rad, more than once around"));
}

TEST(RobotChecks, NamesTwinsThatDiffer) {
  const std::string light = "<inertial pos='0 0 .01' mass='.9' diaginertia='.01 .01 .01'/>";
  const auto differ = examine_symmetry(
      read(limb("left_arm", "1", "range='0 1'") + limb("right_arm", "-1", "range='0 2'", light)).description);
  ASSERT_EQ(differ.size(), 3u);
  EXPECT_TRUE(finds(differ, ":6: 'right_arm' weighs 0.9 kg, 'left_arm' 1 kg"));
  EXPECT_TRUE(finds(differ, "mirror image"));
  const auto ranges =
      examine_symmetry(read(limb("l_arm", "1", "range='0 1'") + limb("r_arm", "-1", "range='-1 0'")).description);
  EXPECT_TRUE(ranges.empty());
  const auto wrong = read(
      "<body name='LArm' pos='0 1 0'><joint name='LElbow' axis='0 1 0' range='0 1'/><geom size='.1'/></body>"
      "<body name='RArm' pos='0 -1 0'><joint name='RElbow' axis='0 1 0' range='0 2'/><geom size='.1'/></body>");
  EXPECT_TRUE(finds(examine_symmetry(wrong.description), "joint 'RElbow' reaches from 0 to 2, 'LElbow' from 0 to 1"));
}

TEST(RobotChecks, NamesOverlapsOfBodiesThatAreNoNeighbors) {
  const std::string arms = limb("one", "1") + limb("two", "1.15");
  EXPECT_TRUE(finds(examine_shapes(read(arms).description), ":6: shapes of 'one' and 'two' overlap by 50.0 mm"));
  const std::string exclusion = "<contact><exclude body1='one' body2='two'/></contact>";
  EXPECT_TRUE(examine_shapes(read(arms, exclusion).description).empty());
}

TEST(RobotChecks, NamesARobotWithoutSoles) {
  const robot::RobotFile robot = read(limb("arm", "1"));
  EXPECT_TRUE(finds(examine_legs(robot.description, *robot.model), "0 soles; a biped needs 2"));
}

// ---- roles ----

/// Three hinges and a foot that is a box of 20 x 10 x 2 cm, turned by 90 degrees about x, as CAD exports like it.
std::string leg(const std::string& side, double y) {
  return "<body name='" + side + "_hip' pos='0 " + std::to_string(y) + " -.2'><joint name='" + side +
         "_a' axis='1 0 0'/><joint name='" + side + "_b' axis='0 1 0'/><geom size='.05'/><body name='" + side +
         "_foot' pos='0 0 -.3' euler='1.5707963267948966 0 0'><joint name='" + side +
         "_c' axis='0 0 1' actuatorfrcrange='-5 5'/><geom type='box' size='.1 .01 .05' pos='.03 0 0'/></body></body>";
}

TEST(RobotRoles, SolesAreGuessedUnderTheFeet) {
  const robot::RobotFile robot = read(leg("left", 0.1) + leg("right", -0.1));
  const auto soles = robot.model->having(properties::sole);
  ASSERT_EQ(soles.size(), 2u);
  const Sole& sole = *robot.model->find(properties::sole, soles[0]);
  EXPECT_NEAR(sole.half_length, 0.1, 1e-9);
  EXPECT_NEAR(sole.half_width, 0.05, 1e-9);
  const auto at = robot.model->placement(robot.model->object_index("left_foot.sole"));
  EXPECT_NEAR(norm(at.offset - Vec3d{0.03, -0.01, 0}), 0, 1e-9);  // y of the foot points up
}

TEST(RobotRoles, ARobotWithoutShapesHasNoFeet) {
  const std::string bare = "<inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>";
  const robot::RobotFile robot =
      read("<body><joint/>" + bare + "<body><joint/>" + bare + "<body><joint/>" + bare + "</body></body></body>");
  EXPECT_TRUE(robot.model->having(properties::sole).empty());
}

TEST(RobotRoles, GuessesNeverMakeARobotUnreadable) {
  const std::string arm =
      "<body name='SIDE'><joint name='JOINT'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>"
      "<site name='SIDE_sole'/><site name='SIDE_camera_imu'/></body>";
  const auto body = [&](const std::string& side, const std::string& joint) {
    std::string text = arm;
    for (auto at = text.find("SIDE"); at != std::string::npos; at = text.find("SIDE")) text.replace(at, 4, side);
    return text.replace(text.find("JOINT"), 5, joint);
  };
  const robot::RobotFile robot = read(body("l", "imu") + body("r", "camera"));  // joints have the names of the roles
  EXPECT_TRUE(robot.model->having(properties::sole).empty()) << "no shape under the frames that are called soles";
  EXPECT_TRUE(robot.table.frames.empty());
}

TEST(RobotRoles, ServosAreGuessedFromTorques) {
  const robot::RobotFile robot = read(leg("left", 0.1) + leg("right", -0.1));
  const Servo* servo = robot.model->find(properties::servo, robot.model->object_index("left_c"));
  ASSERT_TRUE(servo);
  EXPECT_EQ(servo->stall_torque, 5);
  EXPECT_NEAR(servo->position_gain, 4 * 50, 1e-12) << "four times all torque at 0.1 rad, on two legs";
  EXPECT_TRUE(robot.model->find(properties::servo, robot.model->object_index("left_a"))) << "legs need servos";
}

TEST(RobotRoles, AreWrittenAsATableThatReadsBack) {
  const robot::RobotFile robot = read(leg("left", 0.1) + leg("right", -0.1) + "<site name='my_imu'/>");
  EXPECT_TRUE(robot.model->find_object("imu"));
  const auto file = fixtures::temp_folder() / "checks_roles.toml";
  std::ofstream(file) << robot::roles_toml(robot.description, robot.table);
  const robot::RobotConfig table = robot::read_robot_config(file);
  ASSERT_EQ(table.soles.size(), 2u);
  EXPECT_EQ(table.soles[0].name, "left_foot");
  EXPECT_EQ(table.frames.at("imu").name, "my_imu");
  EXPECT_EQ(table.servos.at("left_c").servo.position_gain, 200);
}

}  // namespace
}  // namespace murosimf::robot
