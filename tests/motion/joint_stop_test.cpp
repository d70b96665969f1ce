// Numbers of stops, against arithmetic on an unsymmetric arm.
#include "murosimf/motion/joint_stop.h"

#include <gtest/gtest.h>

#include <limits>

#include "murosimf/model/properties.h"
#include "murosimf/motion/motion_properties.h"

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

}  // namespace
}  // namespace murosimf::motion
