// Joints that another one takes along, at every level that has forces.
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/physics/bolted.h"
#include "tests/physics/mechanics.h"

namespace murosimf::test {
namespace {

constexpr const char* level = "articulated_dynamics";
constexpr double ratio = -1.5, offset = 0.2;
constexpr double m = 0.4, l = 0.15, J = 0.003;  // [kg], [m], [kg m^2] of a finger, at its center

Servo servo() {
  Servo servo;
  servo.law = "ideal_pd";
  servo.stall_torque = 6;
  servo.position_gain = 20;
  servo.velocity_gain = 0.5;
  servo.rotor_inertia = 1e-3;
  return servo;
}

Chain finger(const std::string& name, double side) {
  Chain chain;
  chain.translation({0, side, 0})
      .revolute(name, {0, 1, 0})
      .with(properties::mass, m)
      .with(properties::center_of_mass, {l, 0, 0})
      .with(properties::inertia, diagonal(J));
  return chain;
}

struct HandOptions {
  bool servo = true;
  double friction = 0;  // [N m] of either finger
  JointCoupling coupling{"leader", ratio, offset};
};

/// A palm with two fingers, of which the second follows the first.
Chain hand(const HandOptions& options = {}) {
  Chain leader = finger("leader", 0.1), follower = finger("follower", -0.1);
  leader.with(properties::joint_friction, options.friction);
  if (options.servo) leader.with(properties::servo, servo());
  follower.with(properties::joint_coupling, options.coupling).with(properties::joint_friction, options.friction);
  return Chain{}
      .base("palm")
      .with(properties::mass, 1.5)
      .with(properties::inertia, diagonal(0.01))
      .fork(leader, follower);
}

double at(Entity& robot, const char* joint) { return robot.object(joint).get(properties::joint_position); }

/// [rad] how far the follower is from where the leader takes it.
double gap(Entity& robot) { return std::abs(at(robot, "follower") - offset - ratio * at(robot, "leader")); }

struct FreeHand {
  FreeHand(const std::string& its_level, const Chain& chain, double rate_hz = 1000,
           dynamics::MovingTreeOptions tree = {})
      : rig(0.8, 0, rate_hz) {
    robot = &rig.add("robot", std::make_shared<const Model>("hand", chain), {.position = {0, 0, 2}});
    rig.simulation.world().gravity = {};
    rig.attach_dynamics(*robot,
                        {.level = its_level, .law = law_named("kelvin_voigt"), .on_ground = false, .tree = tree});
    rig.simulation.initialize();
  }
  Rig rig;
  Entity* robot = nullptr;
};

class CoupledAtLevel : public testing::TestWithParam<std::string> {};

// Limit: the project's own. Where motion is given, the ratio holds to rounding.
TEST_P(CoupledAtLevel, FollowerKeepsTheRatioOnTheMove) {
  FreeHand free(GetParam(), hand());
  law::Worst worst;
  double way = 0;
  for (int i = 0; i < 2000; ++i) {
    free.robot->object("leader").set(properties::joint_target, 0.5 * std::sin(5e-3 * i));
    free.rig.simulation.step();
    worst.see(gap(*free.robot), "step", i);
    way = std::max(way, std::abs(at(*free.robot, "leader")));
  }
  EXPECT_GT(way, 0.4);
  law::expect_below({.law = "coupled joints follow a sine of 0.8 Hz: gap between follower and ratio",
                     .level = GetParam(),
                     .source = "offset + ratio * leader"},
                    worst, GetParam() == level ? 1e-3 : 1e-12, "rad");
}
INSTANTIATE_TEST_SUITE_P(Dynamic, CoupledAtLevel, testing::ValuesIn(dynamic_levels()), level_name);

// Rule: levels whose motion is given keep the ratio with Runge-Kutta too; articulated dynamics refuses it.
TEST(MimicJoints, RungeKuttaIsExactOrRefused) {
  const dynamics::MovingTreeOptions rk4{.integrator = dynamics::Integrator::rk4};
  FreeHand free("full_dynamics", hand(), 1000, rk4);
  free.robot->object("leader").set(properties::joint_target, 0.5);
  for (int i = 0; i < 200; ++i) {
    free.rig.simulation.step();
    EXPECT_LT(gap(*free.robot), 1e-12);
  }
  EXPECT_NEAR(at(*free.robot, "leader"), 0.5, 1e-6);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { FreeHand(level, hand(), 1000, rk4); }), {"rk4", "coupled"}));
}

// Both fingers level with gravity: the servo at the leader carries both.
TEST(MimicJoints, LeadersServoCarriesTheFollower) {
  Bolted robot(hand());
  robot.joint("leader").set(properties::joint_target, 0.3);
  robot.rig.run(3);
  const double q = at(*robot.robot, "leader"), follower = at(*robot.robot, "follower");
  const double load = m * g * l * (std::cos(q) + ratio * std::cos(follower));
  law::expect_near({.law = "coupled joints at rest: servo torque at the leader",
                    .level = level,
                    .source = "virtual work of both weights"},
                   robot.joint("leader").get(properties::joint_torque), -load, 1e-6, "N m");
  law::expect_below({.law = "coupled joints at rest, 0.6 N m at the follower: gap", .level = level, .source = "ratio"},
                    gap(*robot.robot), 1e-3, "rad");
  EXPECT_EQ(robot.joint("follower").get(properties::joint_torque), 0) << "it has no servo";
}

// Rule: at full_dynamics the same torque is needed at the leader, none at the follower.
TEST(MimicJoints, NeededTorqueIsTheLeaders) {
  Rig rig;
  Entity& robot = rig.add("robot", std::make_shared<const Model>("hand", hand()));
  rig.attach_dynamics(robot, {.level = "full_dynamics", .on_ground = false, .tree = {.fixed_base = true}});
  rig.simulation.initialize();
  robot.object("leader").set(properties::joint_target, 0.3);
  rig.run(1);
  const double load = m * g * l * (std::cos(0.3) + ratio * std::cos(offset + ratio * 0.3));
  EXPECT_NEAR(robot.object("leader").get(properties::joint_torque), -load, 1e-6);
  EXPECT_EQ(robot.object("follower").get(properties::joint_torque), 0);
}

/// 0.2 N m at the leader, no servo, no gravity.
struct Weightless {
  explicit Weightless(double friction) {
    rig.simulation.world().gravity = {};
    robot = &rig.add("robot", std::make_shared<const Model>("hand", hand({.servo = false, .friction = friction})));
    rig.attach_dynamics(*robot, {.level = level, .on_ground = false, .tree = {.fixed_base = true}});
    rig.simulation.initialize();
    robot->object("leader").set(properties::applied_force, Wrenchd{{0, 0.2, 0}, {}});
  }
  double rate() { return robot->object("leader").get(properties::joint_velocity); }
  Rig rig;
  Entity* robot = nullptr;
};

// Generalized inertia J1 + ratio^2 J2 at the leader.
TEST(MimicJoints, FollowersInertiaCountsAtTheLeader) {
  Weightless hand(0);
  hand.rig.run(1);
  const double inertia = (J + m * l * l) * (1 + ratio * ratio);
  law::expect_near({.law = "coupled joints, 0.2 N m at the leader for 1 s: rate",
                    .level = level,
                    .source = "T t / (J + ratio^2 J)"},
                   hand.rate(), 0.2 / inertia, 1e-4 * 0.2 / inertia, "rad/s");
}

// F + |ratio| F = 0.2 N m: 10 % above, the hand moves by what is left; 10 % below, it does not.
TEST(MimicJoints, FollowersFrictionCountsAtTheLeader) {
  const double inertia = (J + m * l * l) * (1 + ratio * ratio), hold = 0.2 / (1 + std::abs(ratio));
  Weightless sliding(0.9 * hold);
  sliding.rig.run(1);
  law::expect_near({.law = "coupled joints with friction, 0.2 N m at the leader for 1 s: rate",
                    .level = level,
                    .source = "(T - F - |ratio| F) t / (J + ratio^2 J)"},
                   sliding.rate(), 0.02 / inertia, 1e-2 * 0.02 / inertia, "rad/s");
  Weightless sticking(1.1 * hold);
  sticking.rig.run(1);
  EXPECT_EQ(sticking.rate(), 0);
  EXPECT_LT(std::abs(at(*sticking.robot, "leader")), 1e-3);
}

// Semi-implicit steps keep momentum to first order: half the step, half the drift.
TEST(MimicJoints, KeepTheMomentumOfTheRobot) {
  double drift[2];
  for (const int finer : {0, 1}) {
    FreeHand free(level, hand({.servo = false}), finer ? 2000 : 1000, {.momentum_correction = false});
    free.robot->object("leader").set(properties::joint_velocity, 3);
    free.robot->object("follower").set(properties::joint_velocity, 3 * ratio);
    free.robot->base().set(properties::angular_velocity, {0.5, 1, -0.3});
    free.rig.simulation.step();
    const Wrenchd before = momentum(*free.robot);
    free.rig.run(1);
    const Wrenchd change = momentum(*free.robot) - before;
    drift[finer] = norm(change.n);
    EXPECT_LT(gap(*free.robot), 1e-3);
  }
  law::expect_near({.law = "coupled joints in free flight: drift of the moment of momentum, half the step over whole",
                    .level = level,
                    .source = "none but the integrator's: 0.5"},
                   drift[1] / drift[0], 0.5, 0.05, "");
  EXPECT_LT(drift[0], 1e-3);
}

// Rule: a servo at the follower helps, and knows where the leader's target takes it.
TEST(MimicJoints, FollowersServoPullsTheSameWay) {
  Chain leader = finger("leader", 0.1), follower = finger("follower", -0.1);
  leader.with(properties::servo, servo());
  follower.with(properties::servo, servo()).with(properties::joint_coupling, {"leader", ratio, offset});
  Bolted robot(Chain{}.base("palm").fork(leader, follower));
  robot.joint("leader").set(properties::joint_target, 0.4);
  robot.joint("follower").set(properties::joint_target, 3);  // means nothing
  robot.rig.run(2);
  const double q = at(*robot.robot, "leader"), follower_q = at(*robot.robot, "follower");
  const double servos = 20 * (0.4 - q) + ratio * 20 * (offset + ratio * 0.4 - follower_q);
  EXPECT_NEAR(servos, -m * g * l * (std::cos(q) + ratio * std::cos(follower_q)), 1e-3) << "virtual work";
  EXPECT_LT(gap(*robot.robot), 1e-3);
}

// Two followers in a row, of which the last one has the narrowest range.
Chain row_of_three() {
  const auto joint = [](Chain& chain, const char* name) -> Chain& {
    return chain.revolute(name, {0, 1, 0})
        .with(properties::mass, 0.1)
        .with(properties::center_of_mass, {0.05, 0, 0})
        .with(properties::inertia, diagonal(1e-4));
  };
  Chain chain = Chain{}.base("palm").with(properties::mass, 1.0).with(properties::inertia, diagonal(0.01));
  joint(chain, "first").with(properties::servo, servo()).with(properties::joint_range, {-1, 1, 0});
  joint(chain.translation({0.1, 0, 0}), "second").with(properties::joint_coupling, {"first", 2, 0.1});
  joint(chain.translation({0.1, 0, 0}), "third")
      .with(properties::joint_coupling, {"second", -0.5, 0.3})
      .with(properties::joint_range, {0.15, 0.5, 0});
  return chain;
}

TEST_P(CoupledAtLevel, FollowersOfFollowersNarrowTheLeadersRange) {
  FreeHand free(GetParam(), row_of_three());
  // third = 0.25 - first: first is in [-0.25, 0.1]
  for (const double target : {2.0, -2.0}) {
    free.robot->object("first").set(properties::joint_target, target);
    free.rig.run(1);
    const double first = at(*free.robot, "first");
    EXPECT_NEAR(first, target > 0 ? 0.1 : -0.25, GetParam() == level ? 1 * degree : 1e-9);
    EXPECT_NEAR(at(*free.robot, "second"), 0.1 + 2 * first, 2e-3);
    EXPECT_NEAR(at(*free.robot, "third"), 0.25 - first, 2e-3);
  }
}

// Both fingers press on a third body of their own palm, inside an island: forces of contacts come after the coupling.
TEST(MimicJoints, HoldWhileTheFollowerPressesOnItsOwnRobot) {
  PlacedShape tip, wall;
  tip.shape = Sphere{0.02};
  tip.position = {2 * l, 0, 0};
  wall.shape = Box{{0.05, 0.05, 0.02}};
  wall.position = {2 * l, -0.1, -0.15};
  Chain leader = finger("leader", 0.1), follower = finger("follower", -0.1), bracket;
  leader.with(properties::servo, servo());
  follower.with(properties::joint_coupling, {"leader", ratio, offset}).with(properties::shapes, {tip});
  bracket.translation({0, 0, 0}, "bracket").revolute("fence", {1, 0, 0});
  bracket.with(properties::mass, 0.5).with(properties::inertia, diagonal(0.01)).with(properties::shapes, {wall});
  bracket.with(properties::joint_stiffness, 1e4).with(properties::joint_damping, 10);
  Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot =
      rig.add("robot", std::make_shared<const Model>("hand", Chain{}.base("palm").fork(leader, follower, bracket)),
              {.collision = {.self_collision = true}});
  rig.attach_together({{&robot, {.level = level, .on_ground = false, .tree = {.fixed_base = true}}}});
  rig.simulation.initialize();
  robot.object("leader").set(properties::joint_target, -0.6);  // the follower turns down into the fence
  rig.run(2);
  EXPECT_FALSE(robot.base().get(properties::total_mass) == 0);
  EXPECT_GT(std::abs(robot.object("leader").get(properties::joint_torque)), 0.5);
  law::Worst worst;
  const double place = at(robot, "leader");
  for (int i = 0; i < 500; ++i) {
    rig.simulation.step();
    worst.see(gap(robot), "step", i);
    EXPECT_NEAR(at(robot, "leader"), place, 1e-5);
  }
  law::expect_below({.law = "coupled joints press on a fence in an island: gap", .level = level, .source = "ratio"},
                    worst, 1e-3, "rad");
}

// Rule: a change of the level keeps the ratio, and the joints where they are.
TEST(MimicJoints, KeepTheRatioWhenTheLevelChanges) {
  FreeHand free(level, hand());
  free.robot->object("leader").set(properties::joint_target, 0.4);
  for (const std::string next : {"full_dynamics", "simplified_dynamics", level}) {
    free.rig.run(0.3);
    const double before = at(*free.robot, "follower");
    free.rig.exchange(*free.robot, next);
    for (int i = 0; i < 100; ++i) {
      free.rig.simulation.step();
      EXPECT_LT(gap(*free.robot), 1e-3) << next;
      if (i == 0) {
        EXPECT_NEAR(at(*free.robot, "follower"), before, 2e-3) << next;
      }
    }
  }
}

// NaN as a target freezes the robot, and leaves nothing else that is no number.
TEST(MimicJoints, SenselessTargetFreezesTheRobot) {
  FreeHand free(level, hand());
  free.rig.run(0.1);
  free.robot->object("leader").set(properties::joint_target, std::nan(""));
  free.rig.run(0.1);
  EXPECT_TRUE(free.robot->frozen());
  EXPECT_TRUE(std::isfinite(free.robot->object("follower").get(properties::coupling_torque)));
  EXPECT_TRUE(std::isfinite(at(*free.robot, "follower")));
}

TEST(MimicJoints, MistakesAreNamed) {
  const auto error = [](const Chain& chain) { return fixtures::error_of([&] { FreeHand(level, chain); }); };
  const auto with = [](const JointCoupling& coupling) { return hand({.coupling = coupling}); };
  EXPECT_TRUE(fixtures::says(error(with({"leadr"})), {"'follower'", "'leadr'", "'leader'"}));
  EXPECT_TRUE(fixtures::says(error(with({"palm"})), {"'follower'", "'palm'", "no joint"}));
  EXPECT_TRUE(fixtures::says(error(with({"leader", 0})), {"'follower'", "ratio 0"}));
  EXPECT_TRUE(fixtures::says(error(with({"leader", 1, std::nan("")})), {"'follower'", "nan"}));
  EXPECT_TRUE(fixtures::says(error(with({"follower"})), {"'follower'", "follows itself"}));
  Chain apart = row_of_three();
  apart.with(properties::joint_range, {5, 6, 0});
  EXPECT_TRUE(fixtures::says(error(apart), {"'third'", "'first'", "no position in common"}));
  Servo wheel = servo();
  wheel.position_gain = 0;
  Chain turning = Chain{}.base("palm").with(properties::mass, 1.0).with(properties::inertia, diagonal(0.01));
  turning.revolute("leader", {0, 1, 0}).with(properties::servo, wheel).with(properties::mass, 0.1);
  turning.translation({0.1, 0, 0}).revolute("follower", {0, 1, 0}).with(properties::joint_coupling, {"leader"});
  turning.with(properties::mass, 0.1).translation({0.1, 0, 0}).with(properties::mass, 0.1);
  EXPECT_TRUE(fixtures::says(error(turning), {"'follower'", "'leader'", "follows a rate"}));
}

}  // namespace
}  // namespace murosimf::test
