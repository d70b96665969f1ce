// No servo drives its joint beyond the joint's largest rate, whatever moves behind it, at any level.
#include "murosimf/dynamics/rate_limit.h"

#include <gtest/gtest.h>

#include "murosimf/dynamics/mimic_joints.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "tests/dynamics/limb.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

constexpr double most = 2;  // [rad/s]

/// [kg m^2] about a vertical hinge; with `arm` [m] its 1 kg hangs beside a level hinge.
test::LimbModel limb_model(const Servo& servo, double inertia, double arm = 0) {
  return {.servo = servo, .inertia = inertia, .arm = arm, .rate_limit = most};
}

Servo ideal(double torque) {
  return {.law = "ideal_pd", .stall_torque = torque, .position_gain = 10 * torque, .velocity_gain = 0.5 * torque};
}

struct Limb : test::Limb {
  Limb(const test::LimbModel& model, const std::string& level, double target, double rate = 1000,
       ReferenceKind kind = ReferenceKind::filter)
      : test::Limb(model, {.steps_per_second = rate, .level = level, .reference = kind}) {
    go_to(target);
  }
  /// The largest rate on the way.
  double fastest(double time) {
    double fastest = 0;
    run(time, [&] { fastest = std::max(fastest, std::abs(qd())); });
    return fastest;
  }
};

class EveryLevel : public testing::TestWithParam<std::string> {};

TEST_P(EveryLevel, KeepsToTheLargestRate) {
  for (const double target : {1.5, -1.5}) {
    Limb limb(limb_model(ideal(5), 0.0024), GetParam(), target);
    EXPECT_LE(limb.fastest(0.5), most * (1 + 1e-9));
    EXPECT_NEAR(std::abs(limb.q()), most * 0.5, 0.1) << "it is nearly as fast as it may be";
    limb.rig.run(1.0);
    EXPECT_NEAR(limb.q(), target, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(RateLimit, EveryLevel,
                         testing::Values("simplified_dynamics", "full_dynamics", "articulated_dynamics"),
                         test::level_name);

TEST(RateLimit, HoldsForEveryReference) {
  for (const ReferenceKind kind : {ReferenceKind::filter, ReferenceKind::linear, ReferenceKind::exact}) {
    Limb limb(limb_model(ideal(5), 0.01), "full_dynamics", 1.5, 1000, kind);
    EXPECT_LE(limb.fastest(0.5), most * (1 + 1e-9));
    limb.rig.run(0.5);
    EXPECT_NEAR(limb.q(), 1.5, 1e-3) << static_cast<int>(kind);
  }
}

TEST(RateLimit, HoldsForAnyInertiaStepAndLaw) {
  const Servo motor{.law = "dc_motor", .stall_torque = 5, .no_load_speed = 8, .position_gain = 50};
  for (const double inertia : {1e-5, 1e-3, 0.1}) {
    for (const double rate : {100.0, 1000.0, 4000.0}) {
      for (const Servo& servo : {ideal(5), ideal(100), motor}) {
        Limb limb(limb_model(servo, inertia), "articulated_dynamics", 1.5, rate);
        EXPECT_LE(limb.fastest(0.5), most * (1 + 1e-9)) << inertia << ' ' << rate << ' ' << servo.law;
      }
    }
  }
}

// Gravity alone would have driven it to sqrt(2 g / 0.2 m): the servo brakes.
TEST(RateLimit, IsKeptUnderALoadThatPulls) {
  Limb limb(limb_model(ideal(20), 1e-3, 0.2), "articulated_dynamics", 1.5);
  EXPECT_LE(limb.fastest(0.6), most * 1.01);
}

TEST(RateLimit, IsNoneOfAServoThatIsSwitchedOff) {
  Limb limb(limb_model(ideal(20), 1e-3, 0.2), "articulated_dynamics", 0);
  limb.entity.object("j").set(properties::torque_enabled, 0);
  EXPECT_GT(limb.fastest(0.6), 1.5 * most);
}

TEST(RateLimit, LeavesSlowMotionAlone) {
  multibody::MotorTorque<double> torque{3, {2.9, 0.001}, {5}, {-5}};
  limit_rate(rate_limit(ideal(5), 10), 1.0, 0.1, 0.0, torque);
  EXPECT_EQ(torque.now, 3);
  const multibody::TorqueLine<double> line = followed_line(torque, 1.0, 0.0);
  EXPECT_DOUBLE_EQ(line.torque, 2.9);
  EXPECT_EQ(line.inertia, 0.001);
}

double at(const multibody::TorqueLine<double>& line, double acceleration) {
  return line.torque - line.inertia * acceleration;
}

// Torque limits prevail over those of the rate, whichever line the free one leads to. The balance J a = torque + load falls in a.
TEST(RateLimit, LineIsTheOneThatBalances) {
  fixtures::Dice dice("rate limit in turns");
  int by_torque = 0, by_rate = 0;
  for (int i = 0; i < 5000; ++i) {
    const double h = dice.uniform(5e-4, 1e-2), J = std::pow(10.0, dice.uniform(-5, 0)), qd = dice.uniform(-6, 6);
    const Servo servo = ideal(dice.uniform(1, 100));
    multibody::MotorTorque<double> motor =
        make_servo_law(servo)->torque({.target = dice.uniform(-1, 1), .rate = qd}, h);
    limit_rate(rate_limit(servo, 5), 1.0, qd, h, motor);
    const double load = servo.stall_torque * dice.uniform(-3, 3);
    multibody::TorqueLine<double> line = motor.free;
    for (int turn = 1; turn < multibody::lines_in_turn; ++turn) {
      line = followed_line(motor, line, J + line.inertia, line.torque + load);
    }
    const double a = (line.torque + load) / (J + line.inertia);
    const double limited = std::min(std::max(at(motor.free, a), at(motor.floor, a)), at(motor.ceiling, a));
    const double made = std::clamp(limited, at(motor.lowest, a), at(motor.highest, a));
    EXPECT_NEAR(at(line, a), made, 1e-9 * servo.stall_torque) << i;
    by_torque += line == motor.highest || line == motor.lowest;
    by_rate += line == motor.ceiling || line == motor.floor;
  }
  EXPECT_GT(by_torque, 500);
  EXPECT_GT(by_rate, 500);
}

TEST(RateLimit, OfAFollowerIsThatOfItsLeader) {
  const Model model("pair", Chain{}
                                .base("base")
                                .with(properties::mass, 1.0)
                                .with(properties::inertia, diagonal(0.1))
                                .revolute("a", {0, 0, 1})
                                .with(properties::joint_rate_limit, 3.0)
                                .with(properties::mass, 1.0)
                                .with(properties::inertia, diagonal(0.1))
                                .revolute("b", {0, 0, 1})
                                .with(properties::joint_rate_limit, 4.0)
                                .with(properties::joint_coupling, {"a", -2.0, 0.0})
                                .with(properties::mass, 1.0)
                                .with(properties::inertia, diagonal(0.1)));
  const MimicJoints joints(model);
  EXPECT_EQ(joints.rate_limit(model.object_index("a")), 2);
  EXPECT_EQ(joints.rate_limit(model.object_index("b")), 4);
}

TEST(RateLimit, MustNotBeNegative) {
  const auto of = [](double rate) {
    return joint_rate_limit(Model("m",
                                  Chain{}.base("b").revolute("j", {0, 0, 1}).with(properties::joint_rate_limit, rate)),
                            1);
  };
  EXPECT_EQ(of(3), 3);
  EXPECT_TRUE(std::isinf(of(0))) << "none";
  EXPECT_EQ(fixtures::error_of([&] { (void)of(-1); }),
            "model 'm', joint 'j': a largest rate of -1 rad/s (m/s) is none; it must not be negative");
}

}  // namespace
}  // namespace murosimf::dynamics
