// Numbers of passive joints and of stops, against arithmetic on an unsymmetric arm.
#include "murosimf/motion/joint_stop.h"

#include <gtest/gtest.h>

#include <limits>

#include "murosimf/model/properties.h"
#include "murosimf/motion/motion_properties.h"
#include "murosimf/motion/passive_joint.h"
#include "murosimf/motion/velocity_joints.h"
#include "tests/fixtures.h"
#include "tests/motion/part.h"

namespace murosimf::motion {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), g = 9.81;
constexpr double bend = 0.25 * pi / 180, shift = 0.5e-3;  // [rad], [m]

/// Weighs 1 + 0.3 + 2 = 3.3 kg.
Chain arm(const Servo* servo, bool slider) {
  Chain chain = Chain{}.base("base").with(properties::mass, 1.0).with(properties::inertia, diagonal(0.1));
  chain.translation({0.1, 0.2, 0.3});
  slider ? chain.prismatic("joint", {0, 1, 0}) : chain.revolute("joint", {0, 1, 0});
  chain.with(properties::mass, 0.3)
      .with(properties::center_of_mass, {0.05, 7, -0.02})
      .with(properties::inertia, {0.01, 0.02, 0.03, 0, 0, 0})
      .with(properties::joint_armature, 0.004);
  if (servo) chain.with(properties::servo, *servo);
  return chain.translation({0.2, 0.4, 0})
      .rotation({0, 0, 1}, pi / 2)
      .revolute("hand", {1, 0, 0})
      .with(properties::mass, 2.0)
      .with(properties::center_of_mass, {0, 0.1, 0.3})
      .with(properties::inertia, {0.5, 0.6, 0.7, 0, 0, 0});
}

JointStop stop(const Servo* servo, bool slider) {
  const Model model("arm", arm(servo, slider));
  return joint_stop(model, model.object_index("joint"), -0.3, 0.8);
}

// k = T / 0.25 degree, T = the larger of stall torque and weight times 0.1 m; d = 5 ms k.
TEST(JointStopNumbers, WithServoAreThoseOfItsTorqueOrTheWeight) {
  for (const double stall : {2.0, 5.0}) {
    const Servo servo{.stall_torque = stall};
    const JointStop found = stop(&servo, false);
    const double k = std::max(stall, 0.1 * 3.3 * g) / bend;
    EXPECT_NEAR(found.stiffness / k, 1, 1e-12);
    EXPECT_NEAR(found.damping / k, 5e-3, 1e-12);
    EXPECT_EQ(found.lowest, -0.3);
    EXPECT_EQ(found.highest, 0.8);
  }
  for (const double stall : {2.0, 50.0}) {
    const Servo servo{.stall_torque = stall};
    EXPECT_NEAR(stop(&servo, true).stiffness * shift, std::max(stall, 3.3 * g), 1e-9);
  }
}

// J about y through the joint: 0.3 kg at (0.05, -0.02), 2 kg at (0.2 - 0.1, 0.3), whose x axis is the joint's y axis.
TEST(JointStopNumbers, WithoutServoAreAtLeastThoseOfWhatTheJointMoves) {
  const double J = 0.004 + 0.02 + 0.3 * (0.05 * 0.05 + 0.02 * 0.02) + 0.5 + 2 * (0.1 * 0.1 + 0.3 * 0.3);
  const JointStop found = stop(nullptr, false);
  EXPECT_NEAR(found.stiffness, J * 200 * 200, 1e-6);
  EXPECT_NEAR(found.damping, J * 200 * 200 * 10e-3, 1e-8);
  EXPECT_GT(found.stiffness, 0.1 * 3.3 * g / bend);
  EXPECT_NEAR(stop(nullptr, true).stiffness, 2.304 * 200 * 200, 1e-6) << "a slider moves masses";
}

TEST(JointStopNumbers, LightLinksHaveTheStopOfTheWeight) {
  const Model model("light", Chain{}
                                 .base("base")
                                 .with(properties::mass, 3.0)
                                 .revolute("joint", {0, 1, 0})
                                 .with(properties::mass, 0.001)
                                 .with(properties::center_of_mass, {0.01, 0, 0}));
  EXPECT_NEAR(joint_stop(model, 1, -infinity, 1).stiffness, 0.1 * 3.001 * g / bend, 1e-9);
  EXPECT_EQ(joint_stop(model, 1, -infinity, infinity).stiffness, 0) << "no end at all";
  EXPECT_GT(joint_stop(model, 1, -1, infinity).stiffness, 0);
}

TEST(PassiveJoint, IsADamperAndASpring) {
  const Model model("robot", Chain{}
                                 .base("base")
                                 .revolute("joint", {0, 1, 0})
                                 .with(properties::joint_damping, 0.3)
                                 .with(properties::joint_stiffness, 4.0)
                                 .with(properties::joint_spring_reference, -0.2)
                                 .revolute("bare", {0, 1, 0}));
  const PassiveJoint joint = passive_joint(model, 1);
  EXPECT_EQ(joint.damping, 0.3);
  EXPECT_EQ(joint.stiffness, 4);
  EXPECT_EQ(joint.rest, -0.2);
  EXPECT_NEAR(joint.torque(0.5, -2), 0.6 - 4 * 0.7, 1e-15);
  EXPECT_EQ(passive_joint(model, 2).torque(3, 3), 0);
}

TEST(PassiveJoint, RefusesASpringAboutNoPlace) {
  const Model model("robot", Chain{}
                                 .base("base")
                                 .revolute("joint", {0, 1, 0})
                                 .with(properties::joint_stiffness, 1.0)
                                 .with(properties::joint_spring_reference, std::nan("")));
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { (void)passive_joint(model, 1); }), {"'joint'", "a spring of 1"}));
}

Chain wheels() {
  const Servo wheel{.law = "ideal_pd", .velocity_gain = 0.5};
  return Chain{}
      .base("base")
      .revolute("arm", {0, 1, 0})
      .revolute("wheel", {0, 1, 0})
      .with(properties::servo, wheel)
      .revolute("winch", {0, 1, 0})
      .with(properties::servo, wheel)
      .with(properties::joint_range, {-9, 9, 0})
      .prismatic("rail", {0, 1, 0})
      .with(properties::servo, wheel);
}

TEST(VelocityJoints, AreThoseThatFollowARate) {
  test::Alone<VelocityJoints> robot(wheels());
  const VelocityJoints& turning = *robot.part;
  EXPECT_EQ(turning.others(), (std::vector{robot.index("arm")}));
  EXPECT_EQ(turning.joints(), (std::vector{robot.index("wheel"), robot.index("winch"), robot.index("rail")}));
  EXPECT_FALSE(turning.contains(robot.index("arm")));
  EXPECT_TRUE(turning.contains(robot.index("rail")));
  robot.object("winch").set(properties::joint_velocity_target, 3);
  EXPECT_EQ(turning.target(robot.index("winch")), 3);
  EXPECT_EQ(turning.target(robot.index("wheel")), 0);
}

// Only hinges without ends lose whole turns, and only beyond half of one.
TEST(VelocityJoints, WrapTakesWholeTurnsOutOfEndlessHinges) {
  test::Alone<VelocityJoints> robot(wheels());
  std::vector<double> q(static_cast<std::size_t>(robot.entity.model().size()), 4.0);
  robot.part->wrap(q);
  for (const char* name : {"arm", "winch", "rail"}) EXPECT_EQ(q[robot.index(name)], 4) << name;
  double& wheel = q[robot.index("wheel")];
  EXPECT_NEAR(wheel, 4 - 2 * pi, 1e-15);
  for (const double angle : {3.14, -3.14}) {
    wheel = angle;
    robot.part->wrap(q);
    EXPECT_EQ(wheel, angle);
  }
  wheel = -20;
  robot.part->wrap(q);
  EXPECT_NEAR(wheel, -20 + 6 * pi, 1e-14);
}

}  // namespace
}  // namespace murosimf::motion
