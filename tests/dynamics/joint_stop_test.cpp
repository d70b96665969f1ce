// Numbers of stops, against arithmetic on an unsymmetric arm.
#include "murosimf/dynamics/joint_stop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
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

constexpr double frequency = 800, soft_frequency = 200;  // [rad/s]

void expect_spring(const JointStop::Spring& found, double k, double damping_time) {
  EXPECT_NEAR(found.stiffness / k, 1, 1e-12);
  EXPECT_NEAR(found.damping / k, damping_time, 1e-12);
}

// J about y through the joint: 0.3 kg at (0.05, -0.02), 2 kg at (0.2 - 0.1, 0.3), whose x axis is the joint's y axis.
constexpr double J = 0.004 + 0.02 + 0.3 * (0.05 * 0.05 + 0.02 * 0.02) + 0.5 + 2 * (0.1 * 0.1 + 0.3 * 0.3);
constexpr double M = 0.004 + 0.3 + 2;  // [kg] that the slider moves

// k is at least T / 0.25 degree, T = the larger of stall torque and weight times 0.1 m, and J (800 rad/s)^2; d = 5 ms k.
TEST(JointStopNumbers, AreThoseOfTorqueOrWeightAndOfWhatTheJointMoves) {
  for (const double stall : {2.0, 5.0, 3000.0}) {
    const Servo servo{.stall_torque = stall};
    const JointStop found = stop(&servo, false);
    const double k = std::max(stall, 0.1 * 3.3 * g) / bend;
    expect_spring(found.implicit, std::max(k, J * frequency * frequency), 5e-3);
    expect_spring(found.explicitly, k, 5e-3);
    EXPECT_EQ(found.lowest, -0.3);
    EXPECT_EQ(found.highest, 0.8);
  }
  for (const double stall : {2.0, 5000.0}) {
    const Servo servo{.stall_torque = stall};
    const double k = std::max(stall, 3.3 * g) / shift;
    expect_spring(stop(&servo, true).implicit, std::max(k, M * frequency * frequency), 5e-3);
    expect_spring(stop(&servo, true).explicitly, k, 5e-3);
  }
}

TEST(JointStopNumbers, WithoutServoAreFirmExplicitlyToo) {
  expect_spring(stop(nullptr, false).implicit, J * frequency * frequency, 5e-3);
  expect_spring(stop(nullptr, false).explicitly, J * soft_frequency * soft_frequency, 10e-3);
  expect_spring(stop(nullptr, true).explicitly, M * soft_frequency * soft_frequency, 10e-3);
}

TEST(JointStopNumbers, LightLinksHaveTheStopOfTheWeight) {
  const Model model("light", Chain{}
                                 .base("base")
                                 .with(properties::mass, 3.0)
                                 .revolute("joint", {0, 1, 0})
                                 .with(properties::mass, 0.001)
                                 .with(properties::center_of_mass, {0.01, 0, 0}));
  expect_spring(joint_stop(model, 1, -infinity, 1).implicit, 0.1 * 3.001 * g / bend, 5e-3);
  EXPECT_FALSE(joint_stop(model, 1, -infinity, infinity).stops()) << "no end at all";
  EXPECT_TRUE(joint_stop(model, 1, -1, infinity).stops());
}

/// Two links of a finger: the second one's bearing is 0.1 m along x from the first one's, and follows with -0.5. Another finger, beside
/// it, follows with 2.
Chain hand() {
  const auto finger = [](const std::string& name) {
    return Chain{}
        .translation({0, 0.3, 0})
        .revolute(name, {0, 0, 1})
        .with(properties::mass, 0.2)
        .with(properties::center_of_mass, {0.05, 0, 0.7})
        .with(properties::inertia, diagonal(1e-3));
  };
  Chain first = finger("leader");
  first.translation({0.1, 0, 0})
      .revolute("tip", {0, 0, 1})
      .with(properties::mass, 0.1)
      .with(properties::center_of_mass, {0.04, 0, 0})
      .with(properties::inertia, diagonal(2e-4))
      .with(properties::joint_armature, 1e-4)
      .with(properties::joint_coupling, {"leader", -0.5, 0});
  Chain second = finger("second");
  second.with(properties::joint_coupling, {"leader", 2, 0});
  return Chain{}
      .base("base")
      .with(properties::mass, 0.1)
      .with(properties::inertia, diagonal(0.1))
      .fork(std::move(first), std::move(second));
}

// Law: of two bodies at the ends of a gear the inertia is sum(r^2 J); of the tip, that turns with 1 - 0.5 rad/s while its bearing moves
// with 0.1 m/s, 0.5^2 J + m (0.1 + 0.5 * 0.04)^2.
TEST(JointStopNumbers, ALeaderMovesItsFollowersToo) {
  const Model model("hand", hand());
  const MimicJoints coupled(model);
  const double finger = 1e-3 + 0.2 * 0.05 * 0.05;
  const double tip = 0.25 * 2e-4 + 0.1 * 0.12 * 0.12 + 0.25 * 1e-4;
  const double inertia = finger + tip + 4 * finger;
  const auto firmness = [&](const char* joint) {
    return joint_stop(model, model.object_index(joint), -infinity, 1, coupled.pairs()).implicit.stiffness;
  };
  EXPECT_NEAR(firmness("leader") / (inertia * frequency * frequency), 1, 1e-12);
  EXPECT_NEAR(firmness("second") / (finger * frequency * frequency), 1, 1e-12) << "it leads no joint";
}

}  // namespace
}  // namespace murosimf::dynamics
