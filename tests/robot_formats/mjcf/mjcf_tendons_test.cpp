/// mjcf_tendons_test - fixed tendons, against forces computed by hand.
#include "murosimf/robot_formats/mjcf/mjcf_tendons.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/robot_formats/mjcf/mjcf_reader.h"
#include "tests/description_checks.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

using description_checks::any_contains;

/// Three hinges in a row, i, j and k; `coupled`: j = -0.5 i.
robot_formats::RobotDescription read(const std::string& tendon, const std::string& after = "", bool coupled = true,
                                     const std::string& of_i = "") {
  const auto file = fixtures::temp_folder() / "tendons.xml";
  std::ofstream(file)
      << "<mujoco><compiler angle='radian'/><worldbody><body name='b'><freejoint/><geom size='.1'/><body><joint "
         "name='i' axis='0 1 0' "
      << of_i
      << "/><geom size='.1'/><body><joint name='j' axis='0 1 0'/><geom size='.1'/><body><joint name='k' axis='0 1 "
         "0'/><geom size='.1'/></body></body></body></body></worldbody><tendon>"
      << tendon << "</tendon>" << after
      << (coupled ? "<equality><joint joint1='j' joint2='i' polycoef='0 -.5'/></equality>" : "") << "</mujoco>";
  return read_mjcf(file);
}

std::string fixed(const std::string& attributes, const std::string& joints) {
  return "<fixed name='t' " + attributes + ">" + joints + "</fixed>";
}

const std::string both = "<joint joint='i' coef='3'/><joint joint='j' coef='2'/>";  // L = 3 i + 2 j = 2 i

const robot_formats::JointDescription& joint_i(const robot_formats::RobotDescription& description) {
  return description.bodies.at(1).joints.at(0);
}

// A force F along L = 2 i is a torque 2 F about i.
TEST(MjcfTendons, ActAtTheJointThatOthersFollow) {
  const auto robot =
      read(fixed("stiffness='5' damping='.3' frictionloss='.7' armature='.01' range='-1 .4' springlength='.6'", both),
           "", true, "stiffness='10' damping='.1' range='-.3 2'");
  const auto& joint = joint_i(robot);
  EXPECT_NEAR(joint.stiffness, 10 + 4 * 5, 1e-14);
  EXPECT_NEAR(joint.spring_reference, 20 * .3 / 30, 1e-14) << "at rest between 0 and 0.6 / 2";
  EXPECT_NEAR(joint.damping, .1 + 4 * .3, 1e-14);
  EXPECT_NEAR(joint.friction, 2 * .7, 1e-14);
  EXPECT_NEAR(joint.armature, 4 * .01, 1e-14);
  EXPECT_EQ(joint.range->x, -.3) << "of the joint";
  EXPECT_EQ(joint.range->y, .2) << "of the tendon";
  EXPECT_EQ(robot.bodies.at(2).joints.at(0).stiffness, 0);
  EXPECT_FALSE(any_contains(robot.warnings, "tendon"));
}

TEST(MjcfTendons, PassOnTheForcesOfActuators) {
  const auto robot = read(fixed("", both),
                          "<actuator><position name='a' tendon='t' kp='10' kv='2' ctrlrange='-1 1' "
                          "forcerange='-6 6' gear='.5'/></actuator>");
  const auto& joint = joint_i(robot);  // gear .5 x 2
  ASSERT_TRUE(joint.servo);
  EXPECT_NEAR(joint.servo->position_gain, 10, 1e-14);
  EXPECT_NEAR(joint.servo->velocity_gain, 2, 1e-14);
  EXPECT_NEAR(joint.servo->stall_torque, 6, 1e-14);
  EXPECT_NEAR(joint.target_range->y, 1, 1e-14);
  EXPECT_FALSE(any_contains(robot.warnings, "moves nothing"));
  const auto alone = read(fixed("", "<joint joint='i' coef='-2'/>"),
                          "<actuator><position tendon='t' kp='10' ctrlrange='-1 3'/></actuator>");
  EXPECT_NEAR(joint_i(alone).servo->position_gain, 40, 1e-14);
  EXPECT_NEAR(joint_i(alone).target_range->x, -1.5, 1e-14);
  EXPECT_NEAR(joint_i(alone).target_range->y, .5, 1e-14);
}

// What would be wrong at one joint is a slider that stands at the length.
TEST(MjcfTendons, OfSeveralJointsAreJointsOfTheirOwn) {
  using Parts = std::vector<std::pair<std::string, double>>;
  struct Case {
    std::string joints;
    bool coupled;
    std::string of_i;
    Parts parts;
    double rest = 0, start = 0;
  };
  const std::string circle = "<joint joint='i' coef='1'/><joint joint='j' coef='2'/>";
  for (const Case& one :
       {Case{both, false, "", {{"i", 3}, {"j", 2}}},
        {both + "<joint joint='k' coef='1'/>", true, "", {{"i", 3}, {"j", 2}, {"k", 1}}},
        {both + "<joint joint='i' coef='-1'/><joint joint='k' coef='0'/>", false, "", {{"i", 2}, {"j", 2}}},
        {both, true, "ref='.1' springref='.2'", {{"i", 3}, {"j", 2}}, .6, .3},
        {circle, true, "", {{"i", 1}, {"j", 2}}}}) {
    const auto robot =
        read(fixed("stiffness='5' damping='.3' frictionloss='.7' armature='.01' range='-1 .4'", one.joints),
             "<actuator><position name='a' tendon='t' kp='10' kv='2' ctrlrange='-1 1' gear='.5'/></actuator>",
             one.coupled, one.of_i);
    ASSERT_EQ(robot.tendons.size(), 1U) << one.joints;
    const auto& slider = robot.tendons[0].joint;
    EXPECT_EQ(robot.tendons[0].parts, one.parts);
    EXPECT_EQ(slider.name, "t");
    EXPECT_EQ(slider.stiffness, 5);
    EXPECT_NEAR(slider.spring_reference, one.rest, 1e-14);
    EXPECT_NEAR(slider.reference, one.start, 1e-14);
    EXPECT_EQ(slider.damping, .3);
    EXPECT_EQ(slider.friction, .7);
    EXPECT_EQ(slider.armature, .01);
    EXPECT_EQ(slider.range->y, .4);
    ASSERT_TRUE(slider.servo);
    EXPECT_NEAR(slider.servo->position_gain, .25 * 10, 1e-14);
    EXPECT_NEAR(slider.target_range->y, 2, 1e-14);
    EXPECT_EQ(joint_i(robot).stiffness, 0);
    EXPECT_FALSE(joint_i(robot).servo);
    EXPECT_FALSE(any_contains(robot.warnings, "tendon"));
  }
}

TEST(MjcfTendons, ThatOnlyMeasureAreNoJoints) {
  const auto robot = read(fixed("", both), "", false);
  EXPECT_TRUE(robot.tendons.empty());
}

TEST(MjcfTendons, HaveSpringsWithADeadBand) {
  const auto slack = read(fixed("stiffness='5' damping='1' springlength='.25 1'", both));
  EXPECT_TRUE(slack.warnings.empty());
  ASSERT_EQ(slack.tendons.size(), 1U);
  const auto& slider = slack.tendons[0].joint;
  EXPECT_EQ(slider.stiffness, 5);
  EXPECT_EQ(slider.damping, 1);
  EXPECT_EQ(slider.spring_reference, .25);
  EXPECT_EQ(slider.spring_slack, .75);
  const auto complaint =
      fixtures::error_of([&] { (void)read(fixed("stiffness='5' springlength='1 .5'", both), "", false); });
  EXPECT_TRUE(fixtures::says(complaint, {"tendons.xml:1: springlength of a tendon ends below its beginning"}));
}

TEST(MjcfTendons, NeedARangeThatTheirJointHas) {
  const auto complaint = fixtures::error_of([&] { (void)read(fixed("range='2 3'", both), "", true, "range='-1 .5'"); });
  EXPECT_TRUE(
      fixtures::says(complaint,
                     {"tendons.xml:1: no position of joint 'i' is within its own range and that of this tendon"}));
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
