// Torques that given motion takes, joint by joint, against arithmetic on bolted arms.
#include "murosimf/dynamics/full_dynamics.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

using test::g;
using test::Rig;

constexpr double m = 0.4, l = 0.15, J = 0.003, rotor = 0.002;

Chain finger(const char* name, double side, bool servo) {
  Chain chain;
  chain.translation({0, side, 0})
      .revolute(name, {0, 1, 0})
      .with(properties::mass, m)
      .with(properties::center_of_mass, {l, 0, 0})
      .with(properties::inertia, diagonal(J))
      .with(properties::joint_armature, rotor)
      .with(properties::joint_damping, 0.05);
  if (servo) {
    chain.with(properties::servo, {.type = "weak", .law = "ideal_pd", .stall_torque = 0.3, .position_gain = 5});
  }
  return chain;
}

struct Hand {
  explicit Hand(bool coupled, bool both_servos = false, Integrator integrator = Integrator::semi_implicit_euler) {
    Chain follower = finger("follower", -0.1, both_servos);
    if (coupled) follower.with(properties::joint_coupling, {"leader", -1.5, 0.2});
    robot = &rig.add("robot", std::make_shared<const Model>("hand", Chain{}
                                                                        .base("palm")
                                                                        .with(properties::mass, 1.5)
                                                                        .with(properties::inertia, diagonal(0.01))
                                                                        .fork(finger("leader", 0.1, true), follower)));
    rig.attach_dynamics(*robot, {.level = "full_dynamics",
                                 .law = test::law_named("kelvin_voigt"),
                                 .on_ground = false,
                                 .tree = {.integrator = integrator, .fixed_base = true}});
    rig.simulation.initialize();
  }
  struct State {
    double q, qd;
  };
  [[nodiscard]] State state(const char* name) {
    return {robot->object(name).get(properties::joint_position), robot->object(name).get(properties::joint_velocity)};
  }
  [[nodiscard]] double torque(const char* name) { return robot->object(name).get(properties::joint_torque); }
  Rig rig;
  Entity* robot = nullptr;
};

/// What inertia, weight and damper take between two states; the weight at the place before the step.
double taken(const Hand::State& before, const Hand::State& after) {
  const double qdd = (after.qd - before.qd) / 1e-3;
  return (J + m * l * l + rotor) * qdd - m * g * l * std::cos(before.q) + 0.05 * after.qd;
}

TEST(FullDynamicsTorque, IsWhatInertiaWeightAndDamperTake) {
  for (const bool coupled : {false, true}) {
    for (const bool both_servos : {false, true}) {
      Hand hand(coupled, both_servos);
      hand.robot->object("follower").set(properties::joint_target, -0.4);
      for (int i = 0; i < 300; ++i) {
        hand.robot->object("leader").set(properties::joint_target, 0.6 * std::sin(0.03 * i));
        const auto leader = hand.state("leader"), follower = hand.state("follower");
        hand.rig.simulation.step();
        const double of_leader = taken(leader, hand.state("leader"));
        const double of_follower = taken(follower, hand.state("follower"));
        if (coupled && !both_servos) {
          EXPECT_NEAR(hand.torque("leader"), of_leader - 1.5 * of_follower, 1e-10) << i;
          EXPECT_EQ(hand.torque("follower"), 0) << "it has no servo";
        } else {
          EXPECT_NEAR(hand.torque("leader"), of_leader, 1e-10) << i;
          EXPECT_NEAR(hand.torque("follower"), of_follower, 1e-10) << i;
        }
      }
    }
  }
}

// The filter wants qdd = w^2 (target - q) - 2 w qd, w = 120 rad/s, at the first of the four stages.
TEST(FullDynamicsTorque, OfARungeKuttaStepIsThatOfItsBeginning) {
  Hand hand(false, false, Integrator::rk4);
  auto leader = hand.robot->object("leader");
  leader.set(properties::joint_target, 0.4);
  leader.set(properties::joint_velocity, 2);
  hand.rig.simulation.step();
  const double qdd = 120 * 120 * 0.4 - 2 * 120 * 2;
  EXPECT_NEAR(hand.torque("leader"), (J + m * l * l + rotor) * qdd - m * g * l + 0.05 * 2, 1e-9);
}

// The weight of a finger that is level takes 0.59 N m; its servo has 0.3.
TEST(FullDynamicsTorque, WeakServosAreReported) {
  Hand hand(false);
  hand.rig.run(0.5);
  const Overload worst = hand.robot->object("leader").get(properties::overload);
  EXPECT_NEAR(worst.needed, m * g * l, 1e-6);
  EXPECT_NEAR(worst.given, 0.3, 1e-12);
  EXPECT_TRUE(fixtures::says(overload_message(*hand.robot), {"robot: not feasible: leader needs 0.6 Nm", "gives 0.3"}));
}

// An arm on a free base: a push at the hand is carried by the hinge, at the instant that it acts.
TEST(FullDynamicsTorque, PushesAreCarriedByTheJoints) {
  Hand hand(false);
  const double before = [&] {
    hand.rig.simulation.step();
    return hand.torque("leader");
  }();
  hand.robot->object("leader").set(properties::applied_force, Wrenchd{{0, 0.2, 0}, {0, 3, 1}});
  hand.rig.simulation.step();
  EXPECT_NEAR(hand.torque("leader") - before, -0.2, 1e-9) << "a force at the hinge has no arm";
}

TEST(FullDynamicsTorque, IsZeroBeforeTheFirstStep) {
  Hand hand(true);
  EXPECT_EQ(hand.torque("leader"), 0);
  EXPECT_EQ(hand.torque("follower"), 0);
}

// Rule: what a joint is away from its reference when a level takes over fades in 0.1 s, also if the target is an old one.
TEST(FullDynamicsTakeOver, OffsetFades) {
  Simulation simulation;
  Chain hand = Chain{}.base("palm").with(properties::mass, 1.5).with(properties::inertia, diagonal(0.01));
  hand.fork(finger("leader", 0.1, true), finger("other", -0.1, true));
  Entity& robot = simulation.world().add("hand", std::make_shared<const Model>("hand", hand));
  const FullDynamicsOptions options{.reference = {.kind = ReferenceKind::linear, .control_period = 0.01},
                                    .tree = {.fixed_base = true}};
  auto& level = simulation.attach<FullDynamics>("full_dynamics", robot, 1000, options);
  simulation.initialize();
  auto joint = robot.object("leader");
  joint.set(properties::joint_target, 0.4);
  for (int i = 0; i < 20; ++i) simulation.step();
  EXPECT_EQ(joint.get(properties::joint_position), 0.4);
  joint.set(properties::joint_position, 0.1);
  robot.base().set(properties::joint_reference_kind, 0.0);  // as if servos had moved it
  level.take_over({});
  simulation.step();
  EXPECT_NEAR(joint.get(properties::joint_velocity), 0.3 / 1.01 / 0.1, 1e-9);
  EXPECT_NEAR(joint.get(properties::joint_position), 0.4 - 0.3 / 1.01, 1e-12);
}

}  // namespace
}  // namespace murosimf::dynamics
