// The spring between coupled joints: its stiffness, its torque on both joints, and several of them that pull at one leader.
#include "murosimf/dynamics/coupling_forces.h"
#include "murosimf/dynamics/motion_properties.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/physics/bolted.h"

namespace murosimf::dynamics {
namespace {

using test::Bolted;
using test::g;

constexpr double m = 0.4, l = 0.15, J = 0.003;  // [kg], [m], [kg m^2] of a finger

Chain finger(const std::string& name, double side) {
  return Chain{}
      .translation({0, side, 0})
      .revolute(name, {0, 1, 0})
      .with(properties::mass, m)
      .with(properties::center_of_mass, {l, 0, 0})
      .with(properties::inertia, diagonal(J));
}

Servo servo(double stall) {
  return {.law = "ideal_pd", .stall_torque = stall, .position_gain = 20, .velocity_gain = 0.5, .rotor_inertia = 1e-3};
}

/// A palm whose whole weight is `mass` [kg] with fingers at `leader` and followers of these ratios.
Chain hand(double mass, double stall, const std::vector<double>& ratios, double follower_stall = 0) {
  std::vector<Chain> fingers{finger("leader", 0.1).with(properties::servo, servo(stall))};
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    fingers.push_back(
        finger("follower" + std::to_string(i), -0.1).with(properties::joint_coupling, {"leader", ratios[i], 0.2}));
    if (follower_stall > 0) fingers.back().with(properties::servo, servo(follower_stall));
  }
  const double palm = mass - m * static_cast<double>(1 + ratios.size());
  return Chain{}.base("palm").with(properties::mass, palm).with(properties::inertia, diagonal(0.01)).fork(fingers);
}

double q(Bolted& robot, const std::string& name) { return robot.joint(name).get(properties::joint_position); }
double lambda(Bolted& robot, const std::string& name) { return robot.joint(name).get(properties::coupling_torque); }

/// [N m] of the weight of a finger.
double weight(double angle) { return m * g * l * std::cos(angle); }

// At rest: lambda carries the follower's weight, e = -lambda / k with k = T / 0.2 mrad, and the leader's servo carries all.
TEST(CouplingForces, RestOnTheirSpring) {
  struct Case {
    double mass, stall, ratio, T;
  };
  for (const auto& [mass, stall, ratio, T] :
       {Case{3, 6, -1.5, 6 / 1.5}, {3, 6, 0.5, 6 / 0.5}, {40, 6, -1.5, 0.1 * 40 * g}}) {
    Bolted robot(hand(mass, stall, {ratio}));
    robot.joint("leader").set(properties::joint_target, 0.3);
    robot.rig.run(4);
    const double leader = q(robot, "leader"), follower = q(robot, "follower0");
    const double e = follower - 0.2 - ratio * leader, k = T / 0.2e-3;
    EXPECT_NEAR(lambda(robot, "follower0"), -weight(follower), 1e-6) << ratio;
    EXPECT_NEAR(e * k, weight(follower), 1e-5) << ratio;
    EXPECT_NEAR(robot.joint("leader").get(properties::joint_torque), -weight(leader) - ratio * weight(follower), 1e-5);
  }
}

// The leader's dry gear holds both although its servo wants elsewhere: motor and gear together carry the weights.
TEST(CouplingForces, RestOnTheFrictionOfTheLeader) {
  Servo dry = servo(6);
  dry.friction.coulomb = 4;
  Bolted robot(Chain{}
                   .base("palm")
                   .with(properties::mass, 2.2)
                   .with(properties::inertia, diagonal(0.01))
                   .fork(finger("leader", 0.1).with(properties::servo, dry),
                         finger("follower", -0.1).with(properties::joint_coupling, {"leader", -1.5, 0.2})));
  robot.joint("leader").set(properties::joint_target, 0.05);
  robot.rig.run(2);
  EXPECT_EQ(robot.joint("leader").get(properties::joint_velocity), 0);
  EXPECT_NEAR(robot.joint("leader").get(properties::joint_torque),
              -weight(q(robot, "leader")) + 1.5 * weight(q(robot, "follower")), 1e-5);
}

TEST(CouplingForces, FollowersOwnServoMakesItStiffer) {
  Bolted robot(hand(3, 6, {-1.5}, 9));
  robot.rig.run(4);
  const double e = q(robot, "follower0") - 0.2 + 1.5 * q(robot, "leader");
  EXPECT_NEAR(e * 9 / 0.2e-3, -lambda(robot, "follower0"), 1e-5);
}

// Three followers of one leader, each with its own ratio: their springs are settled together.
TEST(CouplingForces, SeveralPullAtOneLeader) {
  const std::vector<double> ratios{-1.5, 0.7, 2};
  Bolted robot(hand(4, 30, ratios));
  double worst = 0;
  for (int i = 0; i < 9000; ++i) {
    robot.joint("leader").set(properties::joint_target, i < 1000 ? 0.3 * std::sin(8e-3 * i) : 0.1);
    robot.rig.simulation.step();
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      worst =
          std::max(worst, std::abs(q(robot, "follower" + std::to_string(k)) - 0.2 - ratios[k] * q(robot, "leader")));
    }
  }
  EXPECT_LT(worst, 1e-3);
  double all = weight(q(robot, "leader"));
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    const std::string name = "follower" + std::to_string(k);
    EXPECT_NEAR(lambda(robot, name), -weight(q(robot, name)), 2e-4) << name;
    all += ratios[k] * weight(q(robot, name));
  }
  EXPECT_NEAR(robot.joint("leader").get(properties::joint_torque), -all, 1e-3);
}

// Law: at the end of every step lambda = -k (e + (h + d/k) e'), e of the beginning and e' of the end, for all springs
// together. Thrown out of rest, with followers of other ratios.
TEST(CouplingForces, AllObeyTheirSpringsInTheSameStep) {
  const std::vector<double> ratios{-1.5, 0.7, 2};
  Bolted robot(hand(4, 30, ratios));
  robot.joint("leader").set(properties::joint_velocity, 0.4);
  robot.joint("follower0").set(properties::joint_velocity, -0.7);
  robot.joint("follower2").set(properties::joint_velocity, 0.3);
  for (int i = 0; i < 5; ++i) {
    std::vector<double> e, expected;
    for (std::size_t k = 0; k < ratios.size(); ++k)
      e.push_back(q(robot, "follower" + std::to_string(k)) - 0.2 - ratios[k] * q(robot, "leader"));
    robot.rig.simulation.step();
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      const std::string name = "follower" + std::to_string(k);
      const double rate = robot.joint(name).get(properties::joint_velocity) -
                          ratios[k] * robot.joint("leader").get(properties::joint_velocity);
      const double stiffness = 30 / std::abs(ratios[k]) / 0.2e-3;  // [N m/rad]
      EXPECT_NEAR(lambda(robot, name), -stiffness * (e[k] + (1e-3 + 0.5e-3) * rate), 1e-6) << name << " " << i;
      EXPECT_GT(std::abs(lambda(robot, name)), 0.01) << name;
    }
  }
}

// A slider that follows a hinge: k = T / 0.02 mm with the robot's weight for T.
TEST(CouplingForces, SlidersAreStifferThanTheWeight) {
  Chain slide = Chain{}
                    .prismatic("slider", {0, 0, 1})
                    .with(properties::mass, 2.0)
                    .with(properties::joint_coupling, {"leader", 0.04, 0.01});
  Bolted robot(Chain{}
                   .base("palm")
                   .with(properties::mass, 1.5)
                   .with(properties::inertia, diagonal(0.01))
                   .fork(finger("leader", 0.1).with(properties::servo, servo(1.5)), slide));
  robot.rig.run(3);
  const double e = q(robot, "slider") - 0.01 - 0.04 * q(robot, "leader");
  EXPECT_NEAR(lambda(robot, "slider"), 2 * g, 1e-4);
  EXPECT_NEAR(e * 3.9 * g / 0.02e-3, -2 * g, 1e-3);
}

// In free flight without gravity nothing from outside: whatever the springs do, momentum stays.
TEST(CouplingForces, AreInside) {
  test::Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("robot", std::make_shared<const Model>("hand", hand(3, 6, {-1.5})), {.position = {0, 0, 2}});
  rig.attach_dynamics(robot, {.level = "articulated_dynamics",
                              .law = test::law_named("kelvin_voigt"),
                              .on_ground = false,
                              .tree = {.momentum_correction = false}});
  rig.simulation.initialize();
  robot.object("leader").set(properties::joint_target, 0.4);
  double most = 0;
  for (int i = 0; i < 500; ++i) {
    rig.simulation.step();
    most = std::max(most, std::abs(robot.object("follower0").get(properties::coupling_torque)));
    const double gap = robot.object("follower0").get(properties::joint_position) - 0.2 +
                       1.5 * robot.object("leader").get(properties::joint_position);
    EXPECT_LT(std::abs(gap), 1e-3);
    EXPECT_LT(norm(test::Rig::velocity(robot)), 5e-3);
  }
  EXPECT_GT(most, 0.1);
  EXPECT_NEAR(robot.object("leader").get(properties::joint_position), 0.4, 0.01);
}

TEST(CouplingForces, StartWithoutTorque) {
  Bolted robot(hand(3, 6, {-1.5}));
  EXPECT_EQ(lambda(robot, "follower0"), 0);
  Bolted plain(Chain{}.base("palm").with(properties::mass, 1.0).fork(finger("leader", 0), finger("other", 1)));
  EXPECT_EQ(plain.robot->find(properties::coupling_torque), nullptr) << "nothing is coupled";
}

}  // namespace
}  // namespace murosimf::dynamics
