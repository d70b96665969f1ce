// Joint reference: ranges, couplings and levels that take over, number by number.
#include <gtest/gtest.h>

#include <limits>

#include "murosimf/dynamics/joint_reference.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "tests/dynamics/part.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

constexpr double h = 2e-3, wf = 90;

Chain joints() {
  return Chain{}
      .base("base")
      .revolute("limited", {0, 1, 0})
      .with(properties::joint_range, {-0.3, 0.8, 0})
      .revolute("free", {0, 1, 0})
      .revolute("follower", {0, 1, 0})
      .with(properties::joint_coupling, {"free", -2, 0.1})
      .revolute("wheel", {0, 1, 0})
      .with(properties::servo, {.law = "ideal_pd", .velocity_gain = 1});
}

struct Reference : test::Alone<JointReference> {
  explicit Reference(ReferenceKind kind = ReferenceKind::filter)
      : Alone(joints(), JointReferenceOptions{.kind = kind, .filter_frequency = wf, .control_period = 0.02}),
        columns(holder.columns) {}
  void want(const char* name, double target) { object(name).set(properties::joint_target, target); }
  double& q(const char* name) { return columns.q[index(name)]; }
  double& qd(const char* name) { return columns.qd[index(name)]; }
  PoseColumns& columns;
};

/// A hinge whose servo turns with 4 rad/s without load.
struct Servoed : test::Alone<JointReference> {
  explicit Servoed(const JointReferenceOptions& options, double duty_limit = 1)
      : Alone(Chain{}
                  .base("base")
                  .revolute("hinge", {0, 1, 0})
                  .with(properties::servo, {.stall_torque = 2, .no_load_speed = 4, .duty_limit = duty_limit}),
              options),
        columns(holder.columns) {}
  [[nodiscard]] double rate() const { return columns.qd[index("hinge")]; }
  PoseColumns& columns;
};

TEST(JointReferenceEnds, StopsThereAtRest) {
  for (const ReferenceKind kind : {ReferenceKind::filter, ReferenceKind::linear}) {
    for (const auto& [target, end] : {std::pair{3.0, 0.8}, {-3.0, -0.3}}) {
      Reference reference(kind);
      reference.part->take_over(reference.columns);
      reference.want("limited", target);
      reference.q("limited") = 0.9 * end;
      reference.qd("limited") = 100 * target;
      // a cycle of `linear` has ten steps, and its rate ends in the step after it
      for (int i = 0; i < (kind == ReferenceKind::filter ? 1 : 11); ++i) {
        EXPECT_TRUE(reference.part->advance(reference.columns, h));
      }
      EXPECT_EQ(reference.q("limited"), end);
      EXPECT_EQ(reference.qd("limited"), 0);
      EXPECT_TRUE(reference.part->advance(reference.columns, h));
      EXPECT_EQ(reference.q("limited"), end);
      EXPECT_EQ(reference.qd("limited"), 0);
    }
  }
}

TEST(JointReferenceEnds, ExactGoesNoFartherThanTheEnd) {
  Reference reference(ReferenceKind::exact);
  reference.part->take_over(reference.columns);
  reference.want("limited", 3);
  reference.want("free", 0.4);
  EXPECT_TRUE(reference.part->advance(reference.columns, h));
  EXPECT_EQ(reference.q("limited"), 0.8);
  EXPECT_DOUBLE_EQ(reference.qd("limited"), 0.8 / h);
  EXPECT_DOUBLE_EQ(reference.q("follower"), -2 * 0.4 + 0.1) << "followers move along";
  EXPECT_TRUE(reference.part->advance(reference.columns, h));
  EXPECT_EQ(reference.q("limited"), 0.8);
  EXPECT_EQ(reference.qd("limited"), 0);
}

TEST(JointReferenceEnds, InsideNothingIsCut) {
  Reference reference;
  reference.q("limited") = 0.8;
  reference.qd("limited") = -3;
  reference.part->stop_at_limits(reference.columns);
  EXPECT_EQ(reference.q("limited"), 0.8);
  EXPECT_EQ(reference.qd("limited"), -3) << "it is at its end, and on its way back";
  reference.q("limited") = -0.3 - 1e-9;
  reference.part->stop_at_limits(reference.columns);
  EXPECT_EQ(reference.q("limited"), -0.3);
  EXPECT_EQ(reference.qd("limited"), 0);
}

TEST(JointReferenceEnds, StartsAtItsTargetsWithinTheRange) {
  Reference reference;
  reference.want("limited", -5);
  reference.want("free", 0.7);
  reference.want("follower", 0.7);
  reference.qd("free") = 4;
  reference.qd("wheel") = -3;
  reference.part->initialize(reference.columns);
  EXPECT_EQ(reference.q("limited"), -0.3);
  EXPECT_EQ(reference.q("free"), 0.7);
  EXPECT_EQ(reference.qd("free"), 0);
  EXPECT_EQ(reference.qd("wheel"), 0);
  EXPECT_DOUBLE_EQ(reference.q("follower"), 0.1 - 2 * 0.7);
}

// One step of the filter by hand; the follower and the wheel by their own rules.
TEST(JointReferenceFilter, StepIsThatOfItsEquation) {
  Reference reference;
  reference.part->initialize(reference.columns);
  reference.want("free", 0.5);
  reference.object("wheel").set(properties::joint_velocity_target, -8);
  reference.q("free") = 0.1;
  reference.qd("free") = 1.5;
  reference.q("wheel") = 0.2;
  reference.qd("wheel") = 3;
  EXPECT_DOUBLE_EQ(reference.part->acceleration(reference.columns, reference.index("free")),
                   wf * wf * 0.4 - 2 * wf * 1.5);
  EXPECT_DOUBLE_EQ(reference.part->acceleration(reference.columns, reference.index("follower")),
                   -2 * (wf * wf * 0.4 - 2 * wf * 1.5));
  EXPECT_DOUBLE_EQ(reference.part->acceleration(reference.columns, reference.index("wheel")), wf * (-8 - 3));
  ASSERT_TRUE(reference.part->advance(reference.columns, h));
  const double qdd = (wf * wf * (0.5 - 0.1 - h * 1.5) - 2 * wf * 1.5) / (1 + 2 * wf * h + wf * wf * h * h);
  EXPECT_NEAR(reference.qd("free"), 1.5 + h * qdd, 1e-14);
  EXPECT_NEAR(reference.q("free"), 0.1 + h * (1.5 + h * qdd), 1e-15);
  EXPECT_NEAR(reference.q("follower"), 0.1 - 2 * reference.q("free"), 1e-15);
  EXPECT_NEAR(reference.qd("follower"), -2 * reference.qd("free"), 1e-14);
  const double rate = 3 + h * wf * (-8 - 3) / (1 + wf * h);
  EXPECT_NEAR(reference.qd("wheel"), rate, 1e-14);
  EXPECT_NEAR(reference.q("wheel"), 0.2 + h * rate, 1e-15);
}

// Rule: for a second after servos a joint is no faster on its way to the reference than its servo without load, then it is.
TEST(JointReferenceTakeOver, CatchesUpNoFasterThanItsServo) {
  constexpr double most = 4;
  for (const ReferenceEntry& entry : joint_references()) {
    Servoed reference({.kind = entry.kind, .filter_frequency = wf, .control_period = h});
    reference.part->take_over(reference.columns);
    double& q = reference.columns.q[reference.index("hinge")];
    double before = 0;
    for (int step = 1; step <= 1000; ++step) {
      reference.object("hinge").set(properties::joint_target, std::min(2.5, 6 * h * step));  // faster than the servo
      ASSERT_TRUE(reference.part->advance(reference.columns, h));
      if (h * step < 1) {
        EXPECT_LE(q - before, most * h + 1e-12) << entry.name << step;
      }
      if (step == 200) {
        EXPECT_NEAR(q, most * h * step, 0.1) << entry.name << ": that fast it is";
      }
      before = q;
    }
    EXPECT_NEAR(q, 2.5, 1e-3) << entry.name;
    reference.object("hinge").set(properties::joint_target, -2.5);
    ASSERT_TRUE(reference.part->advance(reference.columns, h));
    for (int step = 0; step < 5; ++step) ASSERT_TRUE(reference.part->advance(reference.columns, h));
    EXPECT_LT(reference.columns.q[reference.index("hinge")], 2.5 - 2 * most * 6 * h)
        << entry.name << ": the second is over";
  }
}

// w_0 (1 - tau / T) against what brakes it, w_0 with what helps it, and 0.1 w_0 at the least.
TEST(JointReferenceTakeOver, CatchesUpOnTheSpeedTorqueLineOfItsServo) {
  for (const auto& [load, rate] : {std::pair{0.5, 3.0}, {1.0, 2.0}, {-1.0, 4.0}, {3.0, 0.4}}) {
    Servoed reference({.filter_frequency = wf});
    reference.part->take_over(reference.columns);
    reference.object("hinge").set(properties::joint_target, 2.5);
    const std::vector<double> loads(static_cast<std::size_t>(reference.entity.model().size()), load);
    reference.part->know_torques(loads);
    for (int step = 0; step < 50; ++step) ASSERT_TRUE(reference.part->advance(reference.columns, h));
    EXPECT_NEAR(reference.rate(), rate, 1e-12) << load;
  }
}

// Law: at the duty u a motor has u times its no-load rate and its stall torque. In numbers, u = 0.5: 2 rad/s, and at 0.4 of 1 N m
// (1 - 0.4) of that.
TEST(JointReferenceTakeOver, TheFirmwaresDutyLimitsTheServo) {
  for (const auto& [load, rate] : {std::pair{0.0, 2.0}, {0.4, 1.2}}) {
    Servoed reference({.filter_frequency = wf}, 0.5);
    reference.part->take_over(reference.columns);
    reference.object("hinge").set(properties::joint_target, 2.5);
    const std::vector<double> loads(static_cast<std::size_t>(reference.entity.model().size()), load);
    reference.part->know_torques(loads);
    for (int step = 0; step < 50; ++step) ASSERT_TRUE(reference.part->advance(reference.columns, h));
    EXPECT_NEAR(reference.rate(), rate, 1e-12) << load;
  }
}

// Rule: kinematic walking has no limbs that push, and a level after one with the same reference goes on where that was, to the bit.
TEST(JointReferenceTakeOver, IsFreeWithoutLoadAndAfterTheSameReference) {
  Servoed free({.filter_frequency = wf, .carries = false}), alone({.filter_frequency = wf}),
      again({.filter_frequency = wf});
  free.part->take_over(free.columns);
  alone.part->initialize(alone.columns);
  again.part->initialize(again.columns);
  double fastest = 0;
  for (int step = 0; step < 100; ++step) {
    for (Servoed* one : {&free, &alone, &again}) {
      one->object("hinge").set(properties::joint_target, 2.5);
      ASSERT_TRUE(one->part->advance(one->columns, h));
    }
    fastest = std::max(fastest, free.rate());
    again.part->take_over(again.columns);
    EXPECT_EQ(again.rate(), alone.rate()) << step;
  }
  EXPECT_GT(fastest, 2 * 4);
}

// Rule: after a take-over a joint comes to its line as its offset from it fades; a new target begins a cycle all the same.
TEST(JointReferenceLinear, OffsetOfATakeOverFadesBesideTheCycles) {
  Reference reference(ReferenceKind::linear);
  reference.want("free", 0.4);
  reference.q("free") = 0.3;
  reference.qd("free") = -7;
  reference.part->take_over(reference.columns);
  const auto offset = [](int step) { return -0.1 * std::pow(1 + h / 0.1, -step); };
  for (int i = 1; i <= 10; ++i) {
    ASSERT_TRUE(reference.part->advance(reference.columns, h));
    EXPECT_NEAR(reference.q("free"), 0.4 + offset(i), 1e-12);
    EXPECT_NEAR(reference.qd("free"), -offset(i) / 0.1, 1e-12);
  }
  reference.want("free", 0.5);
  ASSERT_TRUE(reference.part->advance(reference.columns, h));
  EXPECT_NEAR(reference.qd("free"), 0.1 / 0.02 - offset(11) / 0.1, 1e-9);
  EXPECT_NEAR(reference.q("free"), 0.4 + h * 0.1 / 0.02 + offset(11), 1e-9);
  for (int i = 0; i < 1500; ++i) ASSERT_TRUE(reference.part->advance(reference.columns, h));
  EXPECT_NEAR(reference.q("free"), 0.5, 1e-6);
  for (int i = 0; i < 3000; ++i) ASSERT_TRUE(reference.part->advance(reference.columns, h));
  EXPECT_EQ(reference.q("free"), 0.5);
  EXPECT_EQ(reference.qd("free"), 0);
  EXPECT_EQ(reference.qd("limited"), 0);
}

TEST(JointReferenceLinear, ANewTargetBeginsANewCycle) {
  Reference reference(ReferenceKind::linear);
  reference.part->initialize(reference.columns);
  reference.want("free", 0.4);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(reference.part->advance(reference.columns, h));
  EXPECT_NEAR(reference.q("free"), 0.16, 1e-12);
  reference.want("free", -0.04);
  ASSERT_TRUE(reference.part->advance(reference.columns, h));
  EXPECT_NEAR(reference.qd("free"), -0.2 / 0.02, 1e-10);
  EXPECT_NEAR(reference.q("free"), 0.14, 1e-12);
}

TEST(JointReferenceSanity, RefusesNumbersThatAreNone) {
  for (const double bad : {std::nan(""), 2e4, -std::numeric_limits<double>::infinity()}) {
    Reference target, rate, position;
    target.want("free", bad);
    EXPECT_FALSE(target.part->advance(target.columns, h)) << bad;
    rate.object("wheel").set(properties::joint_velocity_target, bad);
    EXPECT_FALSE(rate.part->advance(rate.columns, h)) << bad;
    position.q("limited") = bad;
    EXPECT_FALSE(position.part->advance(position.columns, h)) << bad;
  }
  Reference good;
  good.want("free", -4000);
  good.q("limited") = -4000;
  EXPECT_TRUE(good.part->is_sane(good.columns));
}

TEST(JointReferenceCheck, RungeKuttaNeedsTheFilter) {
  Reference filter, linear(ReferenceKind::linear);
  EXPECT_EQ(fixtures::error_of([&] { filter.part->check(Integrator::rk4); }), "no error");
  EXPECT_EQ(fixtures::error_of([&] { linear.part->check(Integrator::semi_implicit_euler); }), "no error");
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { linear.part->check(Integrator::rk4); }), {"rk4", "filter"}));
}

}  // namespace
}  // namespace murosimf::dynamics
