// Joint motion without servos: the filter against its closed form, the linear cycle against arithmetic.
#include "murosimf/dynamics/joint_reference.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/odometer.h"
#include "tests/law.h"
#include "tests/physics/mechanics.h"
#include "tests/physics/rig.h"

namespace murosimf::dynamics {
namespace {

ModelPtr arm(const Servo& servo = {}) {
  return std::make_shared<const Model>("arm", Chain{}
                                                  .base("base")
                                                  .with(properties::mass, 1.0)
                                                  .with(properties::inertia, diagonal(0.1))
                                                  .revolute("hinge", {0, 1, 0})
                                                  .with(properties::servo, servo)
                                                  .endpoint("hand"));
}

struct Arm {
  explicit Arm(const JointReferenceOptions& options, const Servo& servo = {.position_gain = 1})
      : entity(rig.add("arm", arm(servo))) {
    rig.simulation.world().gravity = {};
    rig.attach_dynamics(entity, {.on_ground = false, .options = {.reference = options}});
    rig.simulation.initialize();
  }
  double q() { return entity.object("hinge").get(properties::joint_position); }
  double qd() { return entity.object("hinge").get(properties::joint_velocity); }
  test::Rig rig;
  Entity& entity;
};

// Implicit Euler at 1 ms and w = 120 rad/s is off by about w dt / 2 of the step at most.
TEST(JointReference, FilterFollowsTheCriticallyDampedStep) {
  Arm arm({});
  arm.entity.object("hinge").set(properties::joint_target, 1);
  law::Worst error;
  for (int i = 1; i <= 200; ++i) {
    arm.rig.simulation.step();
    const double t = i * 1e-3;
    error.see(std::abs(arm.q() - (1 - (1 + 120 * t) * std::exp(-120 * t))), "time", t);
    EXPECT_LE(arm.q(), 1 + 1e-12) << "critically damped motion does not overshoot";
  }
  law::expect_below({.law = "step of 1 rad through the filter: error on the way",
                     .level = "joint reference, filter",
                     .source = "critically damped: 1 - (1 + w t) exp(-w t), w = 120 rad/s"},
                    error, 0.05, "rad");
  law::expect_near({.law = "step of 1 rad through the filter: angle after 0.2 s",
                    .level = "joint reference, filter",
                    .source = "the target"},
                   arm.q(), 1, 1e-6, "rad");
}

// qd' = w (rate - qd), the same for all references; implicit Euler as above.
TEST(JointReference, WheelComesToItsRateAndTurnsForEver) {
  for (const ReferenceEntry& entry : joint_references()) {
    const ReferenceKind kind = entry.kind;
    Arm arm({.kind = kind}, {.law = "ideal_pd", .velocity_gain = 0.5});
    arm.entity.object("hinge").set(properties::joint_velocity_target, 20);
    arm.entity.object("hinge").set(properties::joint_target, 3);  // means nothing to a wheel
    law::Worst error;
    for (int i = 1; i <= 1000; ++i) {
      arm.rig.simulation.step();
      error.see(std::abs(arm.qd() / 20 - (1 - std::exp(-120e-3 * i))), "time", 1e-3 * i);
      EXPECT_LE(std::abs(arm.q()), pi);
    }
    const std::string name(entry.name);
    law::expect_below({.law = "a wheel comes to its rate: error on the way, as a part of the rate",
                       .level = "joint reference, " + name,
                       .source = "1 - exp(-w t), w = 120 rad/s"},
                      error, 0.05, "");
  }
}

TEST(JointReference, FilterIsStableWithLongSteps) {
  test::Rig rig(0.8, 0, 50);
  rig.simulation.world().gravity = {};
  Entity& entity = rig.add("arm", arm());
  rig.attach_dynamics(entity, {.on_ground = false});
  rig.simulation.initialize();
  entity.object("hinge").set(properties::joint_target, 1);
  rig.run(2);
  law::expect_near({.law = "step of 1 rad through the filter at 50 Hz: angle after 2 s",
                    .level = "joint reference, filter",
                    .source = "stable with long steps: the target"},
                   entity.object("hinge").get(properties::joint_position), 1, 1e-9, "rad");
}

// Rule: the target is reached at constant rate within one control cycle, exactly, and then held.
TEST(JointReference, LinearReachesTheTargetWithinOneCycle) {
  Arm arm({.kind = ReferenceKind::linear, .control_period = 0.01});
  arm.entity.object("hinge").set(properties::joint_target, 0.2);
  law::Worst angle, rate;
  for (int i = 1; i <= 10; ++i) {
    arm.rig.simulation.step();
    angle.see(std::abs(arm.q() - 0.02 * i), "step", i);
    rate.see(std::abs(arm.qd() - 20), "step", i);
  }
  law::expect_below({.law = "step of 0.2 rad in one control cycle of 10 ms: error of the angle",
                     .level = "joint reference, linear",
                     .source = "a straight line in time"},
                    angle, 1e-12, "rad");
  law::expect_below({.law = "step of 0.2 rad in one control cycle of 10 ms: error of the rate",
                     .level = "joint reference, linear",
                     .source = "a straight line in time"},
                    rate, 1e-9, "rad/s");
  EXPECT_EQ(arm.q(), 0.2);
  arm.rig.simulation.step();
  EXPECT_EQ(arm.q(), 0.2);
  EXPECT_EQ(arm.qd(), 0);
}

// Paper 4.1 and 4.2: the desired position is used as the current one; its rate is what the step makes of it.
TEST(JointReference, ExactIsWhereTheTargetIs) {
  Arm arm({.kind = ReferenceKind::exact});
  law::Worst angle, rate;
  double before = 0;
  for (int i = 1; i <= 200; ++i) {
    const double target = 0.3 * std::sin(0.05 * i);
    arm.entity.object("hinge").set(properties::joint_target, target);
    arm.rig.simulation.step();
    angle.see(std::abs(arm.q() - target), "step", i);
    rate.see(std::abs(arm.qd() - (target - before) / 1e-3), "step", i);
    before = target;
  }
  law::expect_below({.law = "a joint that is moved exactly: distance from its target after each step",
                     .level = "joint reference, exact",
                     .source = "paper 4.1, 4.2"},
                    angle, 1e-15, "rad");
  law::expect_below({.law = "a joint that is moved exactly: error of its rate",
                     .level = "joint reference, exact",
                     .source = "difference of the targets by the step"},
                    rate, 1e-9, "rad/s");
  arm.rig.simulation.step();
  EXPECT_EQ(arm.qd(), 0) << "and it rests when its target does";
}

// Law: nothing outside acts, so the momentum of all links together stays, whatever rate the joints begin with.
TEST(JointReference, ExactKeepsMomentum) {
  test::Rig rig;
  rig.simulation.world().gravity = {};
  Entity& robot = rig.add("robot", test::kid21());
  rig.attach_dynamics(robot, {.level = "full_dynamics",
                              .on_ground = false,
                              .options = {.reference = {.kind = ReferenceKind::exact}}});
  rig.simulation.initialize();
  law::Worst moment;
  for (int i = 1; i <= 100; ++i) {
    for (const int joint : robot.model().joints()) {
      ObjectAccess(robot, joint).set(properties::joint_target, 0.2 * std::sin(0.012 * i));
    }
    rig.simulation.step();
    moment.see(norm(test::momentum(robot).n), "step", i);
    EXPECT_LT(norm(test::momentum(robot).f), 1e-9) << i;
  }
  law::expect_below({.law = "joints that are moved exactly swing by 0.2 rad, with 2.4 rad/s from the first step on, in "
                            "free flight: angular momentum",
                     .level = "full_dynamics, exact",
                     .source = "nothing outside acts: none"},
                    moment, 1e-9, "N m s");
}

// A joint hangs beside its target when a level without servos takes it over: this fades by itself, and not the filter's way.
TEST(JointReference, OffsetOfATakeOverFades) {
  for (const ReferenceEntry& entry : joint_references()) {
    Arm arm({.kind = entry.kind}, {.law = "ideal_pd", .position_gain = 1, .rotor_inertia = 0.01});
    arm.entity.object("hinge").set(properties::joint_target, 0.4);
    arm.entity.object("hinge").set(properties::joint_position, 0.3);
    for (const char* level : {"articulated_dynamics", "simplified_dynamics"}) {
      arm.rig.exchange(arm.entity, level, {.reference = {.kind = entry.kind}});
    }
    law::Worst way, target;
    double before = arm.q();
    for (int i = 1; i <= 500; ++i) {
      if (i > 250) arm.entity.object("hinge").set(properties::joint_target, 0.7);
      arm.rig.simulation.step();
      EXPECT_NEAR(arm.qd(), (arm.q() - before) / 1e-3, 1e-9) << entry.name << i;
      before = arm.q();
      if (i <= 250) way.see(std::abs(arm.q() - (0.4 - 0.1 * std::exp(-0.01 * i))), "step", i);
    }
    EXPECT_NEAR(arm.q(), 0.7 - 0.1 * std::exp(-5), 3e-4) << entry.name << ": it follows all the while";
    law::expect_below({.law = "a joint that a level without servos takes over 0.1 rad beside its target: way less that "
                              "of an offset which fades in 0.1 s",
                       .level = "joint reference, " + std::string(entry.name),
                       .source = "0.1 exp(-t / 0.1 s); the filter lags 17 ms"},
                      way, 0.015, "rad");
  }
}

TEST(Odometer, CountsAFallOnce) {
  test::Rig rig;
  Entity& robot = rig.add("robot", test::kid21());
  rig.attach_dynamics(robot);
  rig.simulation.attach<Odometer>("odometer", robot, 10);
  rig.run(0.5);
  EXPECT_EQ(robot.base().get(properties::falls), 0);
  test::Rig::launch(robot, {1.5, 0, 0}, {0, 4, 0});
  rig.run(4.0);
  EXPECT_EQ(robot.base().get(properties::falls), 1);
  EXPECT_EQ(robot.base().get(properties::lying), 1);
  // it lies on the ground, not in it
  EXPECT_GT(test::Rig::place(robot).z, 0.0);
  EXPECT_LT(norm(test::Rig::velocity(robot)), 0.05);
}

}  // namespace
}  // namespace murosimf::dynamics
