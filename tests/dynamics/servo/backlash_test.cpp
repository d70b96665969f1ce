// Play in a gear, step by step: when the motor side lets go, how it turns alone, where it arrives.
#include "murosimf/dynamics/servo/backlash.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/model/properties.h"
#include "tests/dynamics/part.h"

namespace murosimf::dynamics {
namespace {

constexpr double h = 1e-3, rotor = 0.01, armature = 0.002, J = rotor + armature;

/// Play of 0.02 rad, friction of 0.3 N m and 0.05 N m s/rad.
Chain geared_joint() {
  const Servo geared{.law = "ideal_pd",
                     .position_gain = 5,
                     .rotor_inertia = rotor,
                     .friction = {.coulomb = 0.3, .viscous = 0.05},
                     .backlash = 0.02};
  return Chain{}
      .base("base")
      .revolute("stiff", {0, 1, 0})
      .with(properties::servo, {.law = "ideal_pd", .position_gain = 5, .rotor_inertia = rotor})
      .revolute("loose", {0, 1, 0})
      .with(properties::servo, geared)
      .with(properties::joint_armature, armature);
}

struct Gear : test::Alone<Backlash> {
  Gear() : Alone(geared_joint()), loose(index("loose")), stiff(index("stiff")) {}
  void start(double qd) {
    std::vector<double> rates(static_cast<std::size_t>(entity.model().size()), -50);
    rates[static_cast<std::size_t>(loose)] = qd;
    part->start(rates);
  }
  [[nodiscard]] double play() { return object("loose").get(properties::backlash_play); }
  [[nodiscard]] double side() { return object("loose").get(properties::backlash_side); }
  /// Until the motor side has reached the output, which moves at `qd`; its torque is constant.
  int arrive(double torque, double qd) {
    for (int i = 1; i < 10000; ++i) {
      part->turn(loose, {torque, {torque, 0}}, qd, h);
      if (part->touches(loose)) return i;
    }
    return 0;
  }
  int loose, stiff;
};

TEST(Backlash, StartsInTheMiddleAtTheRateOfTheJoint) {
  Gear gear;
  gear.start(1.7);
  EXPECT_TRUE(gear.part->at(gear.loose));
  EXPECT_FALSE(gear.part->at(gear.stiff));
  EXPECT_FALSE(gear.part->touches(gear.loose));
  EXPECT_TRUE(gear.part->touches(gear.stiff));
  EXPECT_EQ(gear.part->rate(gear.loose), 1.7);
  EXPECT_EQ(gear.part->rate(gear.stiff), 0) << "it has none of its own";
  EXPECT_EQ(gear.play(), 0);
}

// D = J + A + h b, p = (J + A) w + h tau, less the friction's budget: one step by hand.
TEST(Backlash, MotorSideTurnsAloneAsItsEquationSays) {
  Gear gear;
  gear.start(2);
  const MotorTorque motor{.now = 1.5, .free = {1.2, 0.004}};
  const double A = J + motor.free.inertia, D = A + h * 0.05;
  const double rate = (A * 2 + h * 1.2 - h * 0.3) / D;
  gear.part->turn(gear.loose, motor, 0.5, h);
  EXPECT_NEAR(gear.part->rate(gear.loose), rate, 1e-14);
  EXPECT_NEAR(gear.play(), h * (rate - 0.5), 1e-16);
  gear.start(-2);
  gear.part->turn(gear.loose, motor, 0.5, h);
  const double back = (A * -2 + h * 1.2 + h * 0.3) / D;
  EXPECT_NEAR(gear.part->rate(gear.loose), back, 1e-14) << "friction works against the motion";
  EXPECT_NEAR(gear.play(), h * (back - 0.5), 1e-16);
}

TEST(Backlash, FrictionHoldsTheMotorSide) {
  Gear gear;
  gear.start(0.02);  // J w is less than h F
  gear.part->turn(gear.loose, {}, 0, h);
  EXPECT_EQ(gear.part->rate(gear.loose), 0);
  gear.part->turn(gear.loose, {0.29, {0.29, 0}}, 0, h);
  EXPECT_EQ(gear.part->rate(gear.loose), 0);
  gear.part->turn(gear.loose, {-0.31, {-0.31, 0}}, 0, h);
  EXPECT_LT(gear.part->rate(gear.loose), 0);
}

// The motor pushes forward, yet the output runs into the motor side from behind: the side is that of the play, not of a rate.
TEST(Backlash, TouchesOnTheSideOfItsPlay) {
  Gear gear;
  gear.start(0);
  EXPECT_GT(gear.arrive(1, 30), 0);  // the motor side turns with up to 30 rad/s, too slow
  EXPECT_EQ(gear.side(), -1);
  EXPECT_EQ(gear.play(), -0.01);
  EXPECT_GT(gear.part->rate(gear.loose), 0);
  gear.start(0);
  EXPECT_EQ(gear.arrive(0, -20), 1) << "20 mrad in one step are more than half of the play";
  EXPECT_EQ(gear.side(), 1) << "an output that comes back meets a motor side at rest";
  EXPECT_EQ(gear.play(), 0.01);
  EXPECT_EQ(gear.part->rate(gear.loose), 0);
}

// 10 mrad at 2 rad/s without any force but friction's, which takes 0.3 N m / 0.012 kg m^2 = 25 rad/s^2: after 5 ms.
TEST(Backlash, ArrivesAfterHalfThePlay) {
  Gear gear;
  gear.start(2);
  EXPECT_EQ(gear.arrive(0.3, 0), 6);
  EXPECT_EQ(gear.side(), 1);
}

// Both take the difference of their rates up within the step, by the rotor's inertia.
TEST(Backlash, ArrivalIsTheRotorsImpulse) {
  Gear gear;
  gear.start(2);
  gear.arrive(0.3, 0);
  const double w = gear.part->rate(gear.loose);
  EXPECT_NEAR(gear.part->arrival(gear.loose, 0.5, h), J * (w - 0.5) / h, 1e-9);
}

// Side +1 pushes forward. It lets go when it would have to pull: torque of the motor less what the rotor takes itself.
TEST(Backlash, LetsGoWhenItWouldHaveToPull) {
  const auto after = [](double torque, double qd_before, double qd) {
    Gear gear;
    gear.start(0);
    gear.arrive(2, -20);
    EXPECT_EQ(gear.side(), 1);
    gear.part->follow(gear.loose, 1e6, qd_before, h);  // it pushes with all its might: touches
    EXPECT_TRUE(gear.part->touches(gear.loose));
    gear.part->follow(gear.loose, torque, qd, h);
    EXPECT_EQ(gear.part->rate(gear.loose), qd) << "both move as one";
    return gear.part->touches(gear.loose);
  };
  EXPECT_TRUE(after(0.1, 1, 1));
  EXPECT_FALSE(after(-0.1, 1, 1));
  // 0.012 kg m^2 that come from 1 to 0.9 rad/s in 1 ms push with 1.2 N m
  EXPECT_TRUE(after(-1.1, 1, 0.9)) << "the slowing rotor pushes";
  EXPECT_FALSE(after(-1.3, 1, 0.9));
  EXPECT_TRUE(after(1.3, 1, 1.1));
  EXPECT_FALSE(after(1.1, 1, 1.1)) << "the motor cannot even speed its rotor up so fast";
}

// Rule: while it turns alone it bears nothing: a share of the load of the output is no part of its friction.
TEST(Backlash, FrictionOfTheMotorSideAloneKnowsNoLoad) {
  struct Loaded : test::Alone<Backlash> {
    Loaded()
        : Alone(Chain{}
                    .base("base")
                    .revolute("loose", {0, 1, 0})
                    .with(properties::servo, {.law = "ideal_pd",
                                              .position_gain = 5,
                                              .rotor_inertia = rotor,
                                              .friction = {.coulomb = 0.3, .external_load = 0.4},
                                              .backlash = 0.02})) {}
  } gear;
  const int loose = gear.index("loose");
  gear.part->start(std::vector<double>(static_cast<std::size_t>(gear.entity.model().size()), 2.0));
  gear.part->turn(loose, {}, 0, h);
  EXPECT_NEAR(gear.part->rate(loose), 2 - h * 0.3 / rotor, 1e-14);
}

}  // namespace
}  // namespace murosimf::dynamics
