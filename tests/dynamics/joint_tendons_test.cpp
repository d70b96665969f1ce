/// joint_tendons_test - tendons over several joints against the closed forms of what acts along them.
#include "murosimf/multibody/joint_tendon.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/physics/bolted.h"

namespace murosimf::dynamics {
namespace {

using test::Bolted;

constexpr double J1 = 0.02, J2 = 0.05, c1 = 1.5, c2 = -0.5;  // [kg m^2], [m/rad]

/// A wheel about the vertical, which gravity leaves alone.
Chain wheel(const std::string& name, double inertia) {
  return Chain{}.revolute(name, {0, 0, 1}).with(properties::mass, 1.0).with(properties::inertia, diagonal(inertia));
}

Chain tendon(const std::vector<JointTendon::Part>& parts = {{"one", c1}, {"two", c2}}) {
  return Chain{}.prismatic("tendon", {0, 0, 1}).with(properties::joint_tendon, {parts});
}

/// Two wheels side by side, and what is to act along L = c1 q1 + c2 q2.
Chain wheels(Chain along) {
  return Chain{}
      .base("wall")
      .with(properties::mass, 1.0)
      .with(properties::inertia, diagonal(0.01))
      .fork({wheel("one", J1), wheel("two", J2), std::move(along)});
}

double q(Bolted& robot, const std::string& name) { return robot.joint(name).get(properties::joint_position); }
double qd(Bolted& robot, const std::string& name) { return robot.joint(name).get(properties::joint_velocity); }
double length(Bolted& robot) { return c1 * q(robot, "one") + c2 * q(robot, "two"); }

// 1 / (c M^-1 c^T), which the slider makes a thousandth heavier: inertia along the tendon.
constexpr double along = 1 / (c1 * c1 / J1 + c2 * c2 / J2);  // [kg]

// L swings with the frequency sqrt(k / m) of that inertia m, and J1 q1 / c1 - J2 q2 / c2, on which no force acts, stays.
TEST(JointTendons, SwingOnTheirSpring) {
  constexpr double k = 3, start = 0.4;  // [N/m], [rad]
  Bolted robot(wheels(tendon().with(properties::joint_stiffness, k)));
  robot.joint("one").set(properties::joint_position, start);
  const double omega = std::sqrt(k / along);
  double worst = 0, drift = 0;
  for (int i = 1; i <= 1000; ++i) {
    robot.rig.simulation.step();
    worst = std::max(worst, std::abs(length(robot) - c1 * start * std::cos(omega * 1e-3 * i)));
    drift = std::max(drift, std::abs(J1 / c1 * (q(robot, "one") - start) - J2 / c2 * q(robot, "two")));
  }
  EXPECT_LT(worst, 0.01) << "of " << c1 * start;
  EXPECT_LT(drift, 1e-9);
}

// The rate along the tendon dies with the time constant m / d.
TEST(JointTendons, AreBrakedByTheirDamper) {
  constexpr double d = 0.02, w = 3;  // [N s/m], [rad/s]
  Bolted robot(wheels(tendon().with(properties::joint_damping, d)));
  robot.joint("one").set(properties::joint_velocity, w);
  robot.rig.run(0.3);
  const double rate = c1 * qd(robot, "one") + c2 * qd(robot, "two");
  EXPECT_NEAR(rate, c1 * w * std::exp(-d / along * 0.3), 0.01);
}

// Dry friction takes F / m off the rate, then holds.
TEST(JointTendons, AreBrakedAndHeldByFriction) {
  constexpr double F = 0.05, w = 2;
  Bolted robot(wheels(tendon().with(properties::joint_friction, F)));
  robot.joint("one").set(properties::joint_velocity, w);
  const double until_rest = c1 * w * along / F;
  robot.rig.run(0.5 * until_rest);
  EXPECT_NEAR(c1 * qd(robot, "one") + c2 * qd(robot, "two"), 0.5 * c1 * w, 0.02);
  robot.rig.run(until_rest);
  EXPECT_NEAR(c1 * qd(robot, "one") + c2 * qd(robot, "two"), 0, 1e-4);
  EXPECT_GT(std::abs(qd(robot, "one")), 0.01) << "what the tendon does not hold goes on";
}

// A rotor a adds a c c^T to the inertias.
TEST(JointTendons, CarryARotor) {
  constexpr double a = 0.03, torque = 0.2;  // [kg], [N m] by a spring that is not stretched less on the way
  Chain driven = Chain{}
                     .base("wall")
                     .with(properties::mass, 1.0)
                     .with(properties::inertia, diagonal(0.01))
                     .fork({wheel("one", J1)
                                .with(properties::joint_stiffness, 1e-3)
                                .with(properties::joint_spring_reference, torque / 1e-3),
                            wheel("two", J2), tendon().with(properties::joint_armature, a)});
  Bolted robot(std::move(driven));
  robot.rig.run(0.1);
  const double m11 = J1 + a * c1 * c1, m12 = a * c1 * c2, m22 = J2 + a * c2 * c2;
  const double determinant = m11 * m22 - m12 * m12;
  EXPECT_NEAR(qd(robot, "one"), torque * m22 / determinant * 0.1, 2e-3);
  EXPECT_NEAR(qd(robot, "two"), -torque * m12 / determinant * 0.1, 2e-3);
}

TEST(JointTendons, EndAtTheirRange) {
  Bolted robot(wheels(tendon().with(properties::joint_range, {-0.1, 0.3, 0})));
  robot.joint("one").set(properties::joint_velocity, 1.0);
  double longest = 0;
  for (int i = 0; i < 1000; ++i) {
    robot.rig.simulation.step();
    longest = std::max(longest, length(robot));
  }
  EXPECT_GT(longest, 0.29);
  EXPECT_LT(longest, 0.305);
}

// A servo along the tendon pulls it to its target, with torques in proportion to the coefficients; the free motion stays at rest.
TEST(JointTendons, ArePulledByAServo) {
  const Servo servo{.law = "ideal_pd", .stall_torque = 2, .position_gain = 40, .velocity_gain = 1};
  Bolted robot(wheels(tendon().with(properties::servo, servo)));
  robot.joint("tendon").set(properties::joint_target, 0.5);
  robot.rig.run(2);
  EXPECT_NEAR(length(robot), 0.5, 1e-4);
  EXPECT_NEAR(q(robot, "tendon"), 0.5, 1e-4);
  EXPECT_NEAR(q(robot, "one"), 0.5 * along * c1 / J1, 1e-4);
  EXPECT_NEAR(q(robot, "two"), 0.5 * along * c2 / J2, 1e-4);
}

// Joints that are put elsewhere take it along: it has no place of its own, and pulls at nothing.
TEST(JointTendons, GoWhereTheirJointsArePut) {
  Bolted robot(wheels(tendon().with(properties::joint_damping, 1.0)));
  robot.joint("one").set(properties::joint_position, 1.0);
  robot.rig.run(0.1);
  EXPECT_NEAR(q(robot, "one"), 1, 1e-9);
  EXPECT_NEAR(q(robot, "tendon"), c1, 1e-9);
}

TEST(JointTendons, MistakesAreNamed) {
  const auto complaint = [](const std::vector<JointTendon::Part>& parts) {
    return fixtures::error_of([&] { Bolted robot(wheels(tendon(parts))); });
  };
  EXPECT_TRUE(fixtures::says(complaint({{"one", 1}, {"twu", 1}}), {"tendon 'tendon'", "'twu'", "'two'"}));
  EXPECT_TRUE(fixtures::says(complaint({{"one", 1}, {"wall", 1}}), {"tendon 'tendon': 'wall' is no joint"}));
  EXPECT_TRUE(fixtures::says(complaint({{"one", 0}}), {"the coefficient 0 of 'one' must be finite and not zero"}));
  EXPECT_TRUE(fixtures::says(complaint({{"tendon", 1}}), {"'tendon' is a tendon itself"}));
  EXPECT_TRUE(fixtures::says(complaint({}), {"it runs over no joint"}));
}

}  // namespace
}  // namespace murosimf::dynamics
