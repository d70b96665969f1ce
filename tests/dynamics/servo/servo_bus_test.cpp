// Targets on their way to the motors: when each arrives, what is held, what a coupled joint knows.
#include "murosimf/dynamics/servo/servo_bus.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "tests/dynamics/part.h"

namespace murosimf::dynamics {
namespace {

using test::Alone;

/// 1 kHz. Joints: "late" 3 ms behind, "odd" 2.6 ms, "rare" every 5 ms, "both" every 4 ms and 2 ms behind, a wheel 1 ms
/// behind, one that follows "late", one without servo, and one
/// whose period is shorter than a step.
Chain joints() {
  const auto servo = [](double delay, double period) {
    return Servo{.law = "ideal_pd", .position_gain = 5, .command_period = period, .command_delay = delay};
  };
  const Servo wheel{.law = "ideal_pd", .velocity_gain = 0.4, .command_delay = 0.001};
  return Chain{}
      .base("base")
      .revolute("late", {0, 1, 0})
      .with(properties::servo, servo(0.003, 0))
      .revolute("odd", {0, 1, 0})
      .with(properties::servo, servo(0.0026, 0))
      .revolute("rare", {0, 1, 0})
      .with(properties::servo, servo(0, 0.005))
      .revolute("both", {0, 1, 0})
      .with(properties::servo, servo(0.002, 0.004))
      .revolute("wheel", {0, 1, 0})
      .with(properties::servo, wheel)
      .revolute("follower", {0, 1, 0})
      .with(properties::joint_coupling, {"late", -1.5, 0.2})
      .revolute("free", {0, 1, 0})
      .revolute("quick", {0, 1, 0})
      .with(properties::servo, servo(0, 0.0004));
}

struct Bus : Alone<ServoBus> {
  Bus() : Alone(joints()) {}
  void want(const char* name, double target) { object(name).set(properties::joint_target, target); }
  [[nodiscard]] double knows(const char* name) const { return part->target(index(name)); }
  /// In how many steps from now the motor knows the target, which must stay at `before` until then.
  int arrival(const char* name, double before, double target) {
    for (int steps = 1; steps < 20; ++steps) {
      EXPECT_TRUE(part->step(0.001));
      if (knows(name) == target) return steps;
      EXPECT_EQ(knows(name), before) << name;
    }
    return 0;
  }
};

TEST(ServoBus, MotorsKnowTheTargetsOfTheStart) {
  Bus bus;
  for (const char* name : {"late", "odd", "rare", "both", "free"}) bus.want(name, 0.3);
  bus.object("wheel").set(properties::joint_velocity_target, 7);
  bus.part->start();
  for (const char* name : {"late", "odd", "rare", "both", "free"}) EXPECT_EQ(bus.knows(name), 0.3) << name;
  EXPECT_EQ(bus.knows("wheel"), 7);
  for (const char* name : {"rare", "both"}) EXPECT_EQ(bus.object(name).get(properties::sent_target), 0.3) << name;
  EXPECT_DOUBLE_EQ(bus.knows("follower"), 0.2 - 1.5 * 0.3);
  for (const char* name : {"late", "free"}) {  // no target of theirs is held
    EXPECT_EQ(bus.object(name).get(properties::sent_target), 0);
    EXPECT_EQ(bus.object(name).get(properties::sent_target_age), 0);
  }
}

// Rule: a target is known command_delay after the step that sends it; without delay in that step itself.
TEST(ServoBus, DelayIsThatOfTheServoToTheStep) {
  Bus bus;
  bus.part->start();
  bus.want("late", 1);
  EXPECT_EQ(bus.arrival("late", 0, 1), 1 + 3);
  bus.want("odd", 2);
  EXPECT_EQ(bus.arrival("odd", 0, 2), 1 + 3) << "2.6 steps are three";
  bus.want("free", -1);
  EXPECT_EQ(bus.arrival("free", 0, -1), 1);
  bus.object("wheel").set(properties::joint_velocity_target, 4);
  EXPECT_EQ(bus.arrival("wheel", 0, 4), 1 + 1);
}

TEST(ServoBus, TargetsAreSentEverySoOftenAndHeld) {
  Bus bus;
  bus.part->start();
  for (int i = 0; i < 23; ++i) {
    bus.want("rare", i);
    EXPECT_TRUE(bus.part->step(0.001));
    EXPECT_EQ(bus.knows("rare"), i - i % 5);
  }
}

// Law: while targets stay, a step of 3 ms is three of 1 ms.
TEST(ServoBus, ALongStepIsAsManyShortOnes) {
  Bus by_long_steps, by_short_steps;
  by_long_steps.part->start();
  by_short_steps.part->start();
  for (int i = 1; i < 20; ++i) {
    for (const char* name : {"late", "odd", "rare", "both", "free"}) {
      by_long_steps.want(name, i);
      by_short_steps.want(name, i);
    }
    EXPECT_TRUE(by_long_steps.part->step(0.003));
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(by_short_steps.part->step(0.001));
    for (const char* name : {"late", "odd", "rare", "both", "free"}) {
      EXPECT_EQ(by_long_steps.knows(name), by_short_steps.knows(name)) << name << ", " << i;
    }
  }
}

TEST(ServoBus, PeriodsBelowAStepAreOneStep) {
  Bus bus;
  bus.part->start();
  for (int i = 0; i < 5; ++i) {
    bus.want("quick", i);
    EXPECT_TRUE(bus.part->step(0.001));
    EXPECT_EQ(bus.knows("quick"), i);
  }
}

TEST(ServoBus, WhatIsSentNowAndThenArrivesLate) {
  Bus bus;
  bus.want("both", -1);
  bus.part->start();
  for (int i = 0; i < 19; ++i) {
    bus.want("both", i);
    EXPECT_TRUE(bus.part->step(0.001));
    EXPECT_EQ(bus.knows("both"), i < 2 ? -1 : (i - 2) - (i - 2) % 4) << i;
  }
}

TEST(ServoBus, StartForgetsWhatIsOnItsWay) {
  Bus bus;
  bus.part->start();
  bus.want("late", 5);
  bus.want("rare", 5);
  EXPECT_TRUE(bus.part->step(0.001));
  bus.want("late", 6);
  bus.want("rare", 6);
  bus.part->start();
  EXPECT_TRUE(bus.part->step(0.001));
  EXPECT_EQ(bus.knows("late"), 6);
  EXPECT_EQ(bus.knows("rare"), 6);
}

TEST(ServoBus, FollowerKnowsWhereItsLeaderIsTaken) {
  Bus bus;
  bus.part->start();
  bus.want("late", 0.4);
  bus.want("follower", 3);  // means nothing
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(bus.part->step(0.001));
    EXPECT_DOUBLE_EQ(bus.knows("follower"), 0.2 - 1.5 * (i < 3 ? 0 : 0.4)) << i;
  }
}

TEST(ServoBus, WheelsFollowTheirRateAndStandWhereTheyAreTold) {
  Bus bus;
  bus.want("wheel", 0.7);
  bus.object("wheel").set(properties::joint_velocity_target, -3);
  EXPECT_EQ(bus.part->wanted(bus.index("wheel")), -3);
  EXPECT_EQ(bus.part->position_target(bus.index("wheel")), 0.7);
  EXPECT_EQ(bus.part->wanted(bus.index("late")), 0);
}

/// "held" takes targets from -0.2 to 0.3, "slow" comes to them with a time constant of 20 ms, a wheel takes -1 to 2 rad/s.
Chain careful_joints() {
  return Chain{}
      .base("base")
      .revolute("held", {0, 1, 0})
      .with(properties::servo, Servo{.law = "ideal_pd", .position_gain = 5})
      .with(properties::joint_target_range, Vec3d{-0.2, 0.3, 0})
      .revolute("slow", {0, 1, 0})
      .with(properties::servo, Servo{.law = "ideal_pd", .position_gain = 5, .command_filter = 0.02})
      .revolute("wheel", {0, 1, 0})
      .with(properties::servo, Servo{.law = "ideal_pd", .velocity_gain = 0.4})
      .with(properties::joint_target_range, Vec3d{-1, 2, 0});
}

TEST(ServoBus, TargetsAreHeldToTheirRange) {
  Alone<ServoBus> bus(careful_joints());
  bus.part->start();
  for (const auto& [target, held, rate] : {std::array{9.0, 0.3, 2.0}, {-9.0, -0.2, -1.0}, {0.1, 0.1, 0.1}}) {
    bus.object("held").set(properties::joint_target, target);
    bus.object("wheel").set(properties::joint_velocity_target, target);
    EXPECT_TRUE(bus.part->step(0.001));
    EXPECT_EQ(bus.part->target(bus.index("held")), held);
    EXPECT_EQ(bus.part->target(bus.index("wheel")), rate);
    EXPECT_EQ(bus.part->position_target(bus.index("held")), target);
  }
}

TEST(ServoBus, AFilterComesToItsTargetByTheExponentialOfTime) {
  Alone<ServoBus> bus(careful_joints());
  bus.object("slow").set(properties::joint_target, 1.0);
  bus.part->start();
  bus.object("slow").set(properties::joint_target, 3.0);
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(bus.part->step(0.001));
    EXPECT_NEAR(bus.part->target(bus.index("slow")), 3 - 2 * std::exp(-i * 0.001 / 0.02), 1e-12) << i;
  }
  EXPECT_TRUE(bus.part->step(0.01));  // as ten of them
  EXPECT_NEAR(bus.part->target(bus.index("slow")), 3 - 2 * std::exp(-59 * 0.001 / 0.02), 1e-12);
}

TEST(ServoBus, TargetsThatAreNoSensibleNumbersAreRefused) {
  for (const double target : {std::nan(""), 1e4, -1e4, std::numeric_limits<double>::infinity()}) {
    Bus bus;
    bus.part->start();
    bus.want("rare", target);
    EXPECT_FALSE(bus.part->step(0.001)) << target;
  }
  Bus bus;
  bus.part->start();
  for (const char* name : {"late", "rare", "free"}) bus.want(name, -9999);
  EXPECT_TRUE(bus.part->step(0.001));
}

}  // namespace
}  // namespace murosimf::dynamics
