// Damper and spring of a joint itself: their numbers, their torque, and what is no spring.
#include "murosimf/dynamics/passive_joint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(PassiveJoint, HasTheNumbersOfItsJoint) {
  const Model model("arm", Chain{}
                               .base("base")
                               .revolute("one", {0, 1, 0})
                               .with(properties::joint_damping, 0.2)
                               .with(properties::joint_stiffness, 5.0)
                               .with(properties::joint_spring_reference, -0.3)
                               .revolute("other", {1, 0, 0})
                               .with(properties::joint_stiffness, 7.0)
                               .prismatic("plain", {0, 0, 1}));
  const PassiveJoint one = passive_joint(model, model.object_index("one"));
  EXPECT_EQ(one.damping, 0.2);
  EXPECT_EQ(one.stiffness, 5);
  EXPECT_EQ(one.rest, -0.3);
  const PassiveJoint other = passive_joint(model, model.object_index("other"));
  EXPECT_EQ(other.damping, 0);
  EXPECT_EQ(other.stiffness, 7);
  EXPECT_EQ(other.rest, 0);
  EXPECT_EQ(passive_joint(model, model.object_index("plain")).torque(3, 4), 0);
}

// By hand: 5 N m/rad pull back over 0.7 rad, 0.2 N m s/rad brake 3 rad/s.
TEST(PassiveJoint, PullsBackToItsRestAndBrakes) {
  const PassiveJoint joint{.damping = 0.2, .stiffness = 5, .rest = -0.3};
  EXPECT_NEAR(joint.torque(0.4, 3), -3.5 - 0.6, 1e-15);
  EXPECT_NEAR(joint.torque(-0.5, -3), 1 + 0.6, 1e-15);
  EXPECT_EQ(joint.torque(-0.3, 0), 0);
}

// Slack from -0.3 to 0.2, and pulled back over what is beyond.
TEST(PassiveJoint, IsSlackOverARange) {
  const PassiveJoint joint{.damping = 0, .stiffness = 5, .rest = -0.3, .slack = 0.5};
  EXPECT_NEAR(joint.torque(-0.5, 0), 1, 1e-15);
  EXPECT_EQ(joint.torque(-0.3, 0), 0);
  EXPECT_EQ(joint.torque(0.1, 0), 0);
  EXPECT_NEAR(joint.torque(0.6, 0), -2, 1e-15);
  const auto error = [](double slack) {
    const Model model("arm", Chain{}
                                 .base("base")
                                 .revolute("elbow", {0, 1, 0})
                                 .with(properties::joint_stiffness, 1.0)
                                 .with(properties::joint_spring_slack, slack));
    return fixtures::error_of([&] { (void)passive_joint(model, 1); });
  };
  EXPECT_EQ(error(0.5), "no error");
  for (const double slack : {-0.1, infinity, std::nan("")}) {
    EXPECT_TRUE(fixtures::says(error(slack), {"model 'arm', joint 'elbow': its spring is slack over"})) << slack;
  }
}

TEST(PassiveJoint, WhatIsNoSpringIsRefused) {
  const auto error = [](double stiffness, double rest) {
    const Model model("arm", Chain{}
                                 .base("base")
                                 .revolute("elbow", {0, 1, 0})
                                 .with(properties::joint_stiffness, stiffness)
                                 .with(properties::joint_spring_reference, rest));
    return fixtures::error_of([&] { (void)passive_joint(model, 1); });
  };
  EXPECT_EQ(error(0, -2), "no error");
  EXPECT_EQ(error(1e5, 2), "no error");
  for (const double stiffness : {-1e-9, infinity, std::nan("")}) {
    EXPECT_TRUE(fixtures::says(error(stiffness, 0), {"model 'arm', joint 'elbow'", "a spring of"})) << stiffness;
  }
  for (const double rest : {infinity, -infinity, std::nan("")}) {
    EXPECT_TRUE(fixtures::says(error(1, rest), {"joint 'elbow'", "both finite"})) << rest;
  }
}

}  // namespace
}  // namespace murosimf::dynamics
