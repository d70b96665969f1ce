/// robot_roles_test - soles are guessed only under bodies that bear the weight, hands only by names or on both sides.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "murosimf/robot/body_names.h"
#include "murosimf/robot/robot_feet.h"
#include "murosimf/robot/robot_reader.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using namespace robot_formats::urdf::urdf_files;

std::string part(const std::string& name, const std::string& shape, double mass = 1) {
  return link(name,
              fmt::format("<inertial><mass value='{}'/><inertia ixx='.01' iyy='.01' izz='.01'/></inertial>", mass) +
                  (shape.empty() ? "" : collision_xml(shape)));
}

std::string hinge(const std::string& parent, const std::string& child, const std::string& at,
                  const std::string& type = "revolute", const std::string& axis = "0 1 0") {
  return joint(type, parent, child, "<origin xyz='" + at + "'/><axis xyz='" + axis + "'/>" + any_limit, "j_" + child);
}

/// Two hinges below the base at (x, y), the lower one of `type` with `end` at it, 0.5 m below.
std::string limb(const std::string& name, double x, double y, const std::string& end = "<box size='.2 .1 .02'/>",
                 const std::string& type = "revolute") {
  return part(name + "_up", "") + part(name, end) + hinge("base", name + "_up", fmt::format("{} {} -.2", x, y)) +
         hinge(name + "_up", name, "0 0 -.3", type);
}

std::vector<std::string> feet_of(const std::string& limbs) {
  const RobotFile robot = read_robot(write("robot.urdf", robot_xml(limbs)));
  std::vector<std::string> names;
  for (const std::size_t body : find_feet(robot.description)) names.push_back(robot.description.bodies[body].name);
  return names;
}

using Names = std::vector<std::string>;

TEST(RobotFeet, AreWhatTheRobotStandsOn) {
  EXPECT_EQ(feet_of(limb("a", 0, 0.1) + limb("b", 0, -0.1)), (Names{"a", "b"}));
  EXPECT_EQ(feet_of(limb("a", 1, 1) + limb("b", 1, -1) + limb("c", -1, 1) + limb("d", -1, -1)),
            (Names{"a", "b", "c", "d"}));
}

TEST(RobotFeet, AreNoWheels) {
  const std::string wheel = "<sphere radius='.1'/>";
  EXPECT_EQ(feet_of(limb("a", 0, 0.1, wheel, "continuous") + limb("b", 0, -0.1, wheel, "continuous")), Names{});
  EXPECT_EQ(feet_of(limb("a", 0, 0.1, wheel) + limb("b", 0, -0.1, wheel)), (Names{"a", "b"}))
      << "round feet that turn back";
  const std::string plate = "<box size='.2 .1 .02'/>";
  EXPECT_EQ(feet_of(limb("a", 0, 0.1, plate, "continuous") + limb("b", 0, -0.1, plate, "continuous")),
            (Names{"a", "b"}))
      << "not round";
}

TEST(RobotFeet, AreNoHands) {
  EXPECT_EQ(feet_of(limb("l_gripper", 0, 0.1) + limb("r_gripper", 0, -0.1)), Names{});
  EXPECT_EQ(feet_of(limb("l_finger", 0, 0.1) + limb("r_finger", 0, -0.1)), Names{});
}

TEST(RobotFeet, AreBelowTheWeight) {
  EXPECT_EQ(feet_of(limb("a", 0.2, 0.1) + limb("b", 0.2, -0.1)), (Names{"a", "b"}));
  EXPECT_EQ(feet_of(limb("a", 2, 0.1) + limb("b", 2, -0.1)), Names{}) << "0.3 m behind them";
}

TEST(RobotFeet, AreNoneIfTheBaseIsAsLow) {
  EXPECT_EQ(feet_of(limb("a", 0, 0.1) + limb("b", 0, -0.1) + link("stand", collision_xml("<box size='.1 .1 1.02'/>")) +
                    joint("fixed", "base", "stand", "", "weld")),
            Names{});
}

TEST(RobotFeet, AreBehindAsManyJointsEach) {
  const std::string longer = part("c_up", "") + part("c_down", "") + part("c", "<sphere radius='.01'/>") +
                             hinge("base", "c_up", "0 -.1 -.2") + hinge("c_up", "c_down", "0 0 -.1") +
                             hinge("c_down", "c", "0 0 -.2");
  EXPECT_EQ(feet_of(limb("a", 0, 0.1) + longer), Names{});
}

TEST(RobotFeet, HaveToes) {
  const std::string toe = "<sphere radius='.01'/>";
  EXPECT_EQ(feet_of(limb("a", 0, 0.1) + limb("b", 0, -0.1) + part("c", toe) + part("d", toe) +
                    hinge("a", "c", "0.1 0 0") + hinge("b", "d", "0.1 0 0")),
            (Names{"a", "b"}));
}

TEST(RobotHands, EndWhereFingersBegin) {
  const std::string arm = limb("left_wrist", 0, 0.3) + part("left_hand_one", "") + part("left_hand_two", "") +
                          hinge("left_wrist", "left_hand_one", "0 0 -.1") +
                          hinge("left_wrist", "left_hand_two", "0 .1 -.1");
  const RobotFile robot = read_robot(write("robot.urdf", robot_xml(arm)));
  EXPECT_EQ(robot.table.frames.at("left_hand").name, "left_wrist");
  EXPECT_FALSE(robot.table.frames.contains("right_hand"));
}

TEST(RobotHands, AreOnTheSideThatTheirNamesSay) {
  // it faces backwards: the foot that is called left is at negative y
  const RobotFile robot = read_robot(write("robot.urdf", robot_xml(limb("r_hand", 0, 0.3) + limb("l_hand", 0, -0.3))));
  EXPECT_EQ(robot.table.frames.at("left_hand").name, "l_hand");
  EXPECT_EQ(robot.table.frames.at("right_hand").name, "r_hand");
}

TEST(RobotHands, AreTwoWhereNamesSayNoSide) {
  const auto frames = [](const std::string& limbs) {
    return read_robot(write("robot.urdf", robot_xml(limbs))).table.frames;
  };
  EXPECT_EQ(frames(limb("gripper_a", 0, -0.3) + limb("gripper_b", 0, 0.3)).at("left_hand").name, "gripper_b");
  EXPECT_TRUE(frames(limb("wrist", 0, 0.3)).empty()) << "an arm on a table has no left hand";
}

TEST(RobotSoles, AreLeftAndRightAsTheirNamesSay) {
  const RobotFile robot = read_robot(write("robot.urdf", robot_xml(limb("r_foot", 0, 0.1) + limb("l_foot", 0, -0.1))));
  ASSERT_EQ(robot.table.soles.size(), 2u);
  EXPECT_EQ(robot.table.soles[0].name, "l_foot");
}

TEST(BodyNames, SayTheirSide) {
  for (const char* left : {"left_hand", "l_hand", "hand_l", "LHand", "L_HAND", "hand_l_roll", "LeftHand"})
    EXPECT_EQ(side_of(left), Side::left) << left;
  EXPECT_EQ(side_of("RFinger12"), Side::right);
  for (const char* none : {"Link_3", "LF_SHANK", "leg", "roll", "l_r", "LINK"})
    EXPECT_EQ(side_of(none), Side::unknown) << none;
}

}  // namespace
}  // namespace murosimf::robot
