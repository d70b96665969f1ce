/// spatial_tendons_test - strings through bodies, and tendons that are tied to each other, against closed forms.
#include "murosimf/multibody/spatial_tendon.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/mimic_joints.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/multibody/joint_tendon.h"
#include "tests/fixtures.h"
#include "tests/physics/bolted.h"

namespace murosimf::dynamics {
namespace {

using test::Bolted;

constexpr double J1 = 0.02, J2 = 0.05, arm = 0.3;  // [kg m^2], [m]

/// A wheel about the vertical at a place, with a pin on its rim, which gravity leaves alone.
Chain wheel(const std::string& name, double inertia, double y) {
  return Chain{}
      .translation({0, y, 0}, name + ".place")
      .revolute(name, {0, 0, 1})
      .with(properties::mass, 1.0)
      .with(properties::inertia, diagonal(inertia))
      .fork({Chain{}.translation({arm, 0, 0}, name + ".pin")});
}

SpatialTendon between(const std::string& one, const std::string& other, const Vec3d& at = {}) {
  return {{{1, {{{one, {at, {}}}}, {{other, {}}}}}}};
}

Chain slider(const std::string& name, const SpatialTendon& path) {
  return Chain{}.prismatic(name, {0, 0, 1}).with(properties::spatial_tendon, path);
}

Chain wheels(const std::vector<Chain>& tendons) {
  std::vector<Chain> branches{wheel("one", J1, 0), wheel("two", J2, 1)};
  branches.insert(branches.end(), tendons.begin(), tendons.end());
  return Chain{}.base("wall").with(properties::mass, 1.0).with(properties::inertia, diagonal(0.01)).fork(branches);
}

double q(Bolted& robot, const std::string& name) { return robot.joint(name).get(properties::joint_position); }
double qd(Bolted& robot, const std::string& name) { return robot.joint(name).get(properties::joint_velocity); }
double between_pins(Bolted& robot) {
  const double a = q(robot, "one"), b = q(robot, "two");
  return norm(Vec3d{arm * (std::cos(b) - std::cos(a)), 1 + arm * (std::sin(b) - std::sin(a)), 0});
}

// With a spring along the string the energy stays, and the slider is as long as the string.
TEST(SpatialTendons, KeepEnergyOnASpring) {
  constexpr double k = 30, rest = 0.8;
  Bolted robot(wheels({slider("string", between("one.pin", "two.pin"))
                           .with(properties::joint_stiffness, k)
                           .with(properties::joint_spring_reference, rest)}));
  robot.joint("one").set(properties::joint_velocity, 3.0);
  const auto energy = [&] {
    const double stretch = between_pins(robot) - rest;
    return 0.5 * (J1 * qd(robot, "one") * qd(robot, "one") + J2 * qd(robot, "two") * qd(robot, "two") +
                  k * stretch * stretch);
  };
  const double start = energy();
  double worst = 0, slack = 0;
  for (int i = 0; i < 2000; ++i) {
    robot.rig.simulation.step();
    worst = std::max(worst, std::abs(energy() - start));
    slack = std::max(slack, std::abs(q(robot, "string") - between_pins(robot)));
  }
  EXPECT_LT(worst, 0.02 * start);
  EXPECT_LT(slack, 2e-4);
}

// A force F along the string is a torque F dL/dq about each joint: a servo that pulls with its limit turns the wheels in this ratio.
TEST(SpatialTendons, PullWithTheirMomentArms) {
  const Servo servo{.law = "ideal_pd", .stall_torque = 5, .position_gain = 1e6, .velocity_gain = 0};
  Bolted robot(wheels({slider("string", between("one.pin", "two.pin")).with(properties::servo, servo)}));
  robot.joint("one").set(properties::joint_position, 0.5);
  robot.joint("two").set(properties::joint_position, -0.2);
  robot.joint("string").set(properties::joint_target, 0.1);
  const double L = between_pins(robot), dx = arm * (std::cos(-0.2) - std::cos(0.5)),
               dy = 1 + arm * (std::sin(-0.2) - std::sin(0.5));
  const double slope1 = (dx * arm * std::sin(0.5) - dy * arm * std::cos(0.5)) / L;
  const double slope2 = (-dx * arm * std::sin(-0.2) + dy * arm * std::cos(-0.2)) / L;
  robot.rig.run(0.01);
  EXPECT_NEAR(qd(robot, "one"), -5 * slope1 / J1 * 0.01, 0.02 * 5 * std::abs(slope1) / J1 * 0.01);
  EXPECT_NEAR(qd(robot, "two"), -5 * slope2 / J2 * 0.01, 0.02 * 5 * std::abs(slope2) / J2 * 0.01);
}

/// One wheel, driven by a torque [N m], and a tendon.
Chain driven(double torque, const Chain& tendon) {
  const Servo pull{.law = "ideal_pd", .stall_torque = torque, .position_gain = 1e6, .velocity_gain = 0};
  Chain one = Chain{}
                  .revolute("one", {0, 0, 1})
                  .with(properties::mass, 1.0)
                  .with(properties::inertia, diagonal(J1))
                  .with(properties::servo, pull)
                  .fork({Chain{}.translation({arm, 0, 0}, "one.pin")});
  return Chain{}.base("wall").with(properties::mass, 1.0).with(properties::inertia, diagonal(0.01)).fork({one, tendon});
}

// Dry friction holds what pulls with less, and lets slip what pulls with more, from the first step on.
TEST(SpatialTendons, AreHeldByFriction) {
  constexpr double friction = 5;  // [N] 1.5 N m about the wheel
  for (const auto& [torque, rate] : {std::pair{0.5, 0.0}, std::pair{2.0, 0.5 / J1 * 0.1}}) {
    const SpatialTendon far_up{{{1, {{{"one.pin", {}}}, {{"wall", {{arm, 50, 0}, {}}}}}}}};
    Bolted robot(driven(torque, slider("string", far_up).with(properties::joint_friction, friction)));
    robot.joint("one").set(properties::joint_target, 3.0);
    robot.rig.run(0.1);
    EXPECT_NEAR(qd(robot, "one"), rate, 0.05 * rate + 1e-4) << torque << " N m";
  }
}

// One that is tied to none keeps its length, and the wheel its place.
TEST(SpatialTendons, AreHeldAtALength) {
  const double start = std::hypot(2 - arm, 1.0);
  const SpatialTendon path{{{1, {{{"one.pin", {}}}, {{"wall", {{2, 1, 0}, {}}}}}}}};
  const Chain string = slider("string", path);
  Bolted loose(driven(2, string)), held(driven(2, Chain(string).with(properties::tendon_tie, {"", start, 0, {}})));
  for (Bolted* robot : {&loose, &held}) {
    robot->joint("one").set(properties::joint_target, 3.0);
    robot->rig.run(0.1);
  }
  EXPECT_GT(q(loose, "one"), 0.3);
  EXPECT_NEAR(q(held, "one"), 0, 1e-3);
  EXPECT_NEAR(q(held, "string"), start, 1e-4);
}

// A tendon that is tied to another one has the length that its polynomial says; each reaction is what the other feels.
TEST(SpatialTendons, AreTiedByAPolynomial) {
  const auto turns = [](const std::string& name, const std::string& joint) {
    return Chain{}.prismatic(name, {0, 0, 1}).with(properties::joint_tendon, {{{joint, 1}}});
  };
  Bolted robot(wheels({turns("first", "one").with(properties::tendon_tie, {"second", 0, 0, {0, 0.5, 0.3, 0, 0}}),
                       turns("second", "two")}));
  robot.joint("two").set(properties::joint_velocity, 1.0);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    robot.rig.simulation.step();
    const double x = q(robot, "two");
    worst = std::max(worst, std::abs(q(robot, "one") - (0.5 * x + 0.3 * x * x)));
  }
  EXPECT_LT(worst, 1e-3);
  EXPECT_GT(q(robot, "two"), 0.3) << "it moves";
}

TEST(SpatialTendons, MistakesAreNamed) {
  const auto complaint = [](const Chain& tendon) {
    return fixtures::error_of([&] { Bolted robot(wheels({tendon})); });
  };
  EXPECT_TRUE(fixtures::says(complaint(slider("string", between("one.pin", "pin"))), {"tendon 'string'", "'pin'"}));
  EXPECT_TRUE(fixtures::says(complaint(slider("string", between("wall", "wall", {1, 0, 0}))),
                             {"tendon 'string': no joint is between its points"}));
  EXPECT_TRUE(fixtures::says(complaint(slider("string", between("one.pin", "two.pin"))
                                           .with(properties::tendon_tie, {"two", 0, 0, {0, 1, 0, 0, 0}})),
                             {"tendon 'string': it is tied to 'two', which is no other tendon"}));
}

}  // namespace
}  // namespace murosimf::dynamics
