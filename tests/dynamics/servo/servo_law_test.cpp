// Servo laws as functions: torque and its slope, what a servo has left, which laws there are.
#include "murosimf/dynamics/servo/servo_law.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

constexpr double h = 2e-3;

Servo pd() { return {.type = "pd", .law = "ideal_pd", .stall_torque = 7, .position_gain = 20, .velocity_gain = 0.6}; }

TEST(IdealPd, IsLinearWithinItsLimit) {
  const auto law = make_servo_law(pd());
  const MotorTorque torque = law->torque({.target = 0.5, .q = 0.3, .rate = -1.1}, h);
  EXPECT_NEAR(torque.now, 20 * 0.2 + 0.6 * 1.1, 1e-14);
  EXPECT_NEAR(torque.free.torque, torque.now + h * 20 * 1.1, 1e-14);
  EXPECT_NEAR(torque.free.inertia, h * 0.6 + h * h * 20, 1e-16);
  const MotorTorque off = law->torque({.target = 0.5, .q = 0.3, .rate = -1.1, .enabled = 0}, h);
  EXPECT_EQ(off.now, 0);
  EXPECT_EQ(followed_line(off, 1.0, 0.0).torque, 0);
  EXPECT_EQ(followed_line(off, 1.0, 0.0).inertia, 0);
}

TEST(IdealPd, HasTheGainsAndTheLimitOfSoftware) {
  const auto law = make_servo_law(pd());
  const MotorInput input{.target = 0.5, .q = 0.3, .rate = -1.1, .gain = 0.25, .damping = 0.3};
  const MotorTorque torque = law->torque(input, h);
  EXPECT_NEAR(torque.now, 5 * 0.2 + 0.9 * 1.1, 1e-14);
  EXPECT_NEAR(torque.free.inertia, h * 0.9 + h * h * 5, 1e-16);
  const MotorTorque weak = law->torque({.target = 1, .q = 0.1, .limit = 1.5}, h);
  EXPECT_EQ(weak.now, 1.5);
  EXPECT_EQ(followed_line(weak, 1.0, 0.0).torque, 1.5);
  EXPECT_EQ(law->torque({.target = 1, .q = 0.1, .limit = 100}, h).now, 7) << "its own limit holds, too";
}

TEST(DcMotor, HasTheGainsAndTheLimitOfSoftware) {
  const auto law = make_servo_law({.type = "motor", .stall_torque = 6, .no_load_speed = 8, .position_gain = 20});
  const double line = 6.0 / 8;
  MotorInput input{.target = 0.5, .q = 0.4, .rate = 1.2, .supply = 0.5, .gain = 2, .damping = 0.3};
  const MotorTorque torque = law->torque(input, h);
  EXPECT_NEAR(torque.now, 0.5 * (40 * 0.1 - 0.3 * 1.2) - line * 1.2, 1e-14);
  EXPECT_NEAR(torque.free.torque, torque.now - h * 0.5 * 40 * 1.2, 1e-14);
  EXPECT_NEAR(torque.free.inertia, h * (line + 0.5 * 0.3) + h * h * 0.5 * 40, 1e-15);
  input.limit = 0.2;  // of the motor's torque, not of the duty
  EXPECT_NEAR(law->torque(input, h).now, 0.2, 1e-14);
  input.target = -3;
  EXPECT_NEAR(law->torque(input, h).now, -0.2, 1e-14);
}

TEST(IdealPd, GivesItsLimitAndNoMore) {
  const auto law = make_servo_law(pd());
  for (const double side : {1.0, -1.0}) {
    const MotorTorque torque = law->torque({.target = side, .q = 0.1, .rate = 0.3}, h);
    EXPECT_EQ(torque.now, 7 * side);
    EXPECT_EQ(followed_line(torque, 1.0, 0.0).torque, 7 * side);
    EXPECT_EQ(followed_line(torque, 1.0, 0.0).inertia, 0);
  }
  // now beyond the limit, at the end of the step within it: the end decides
  const MotorTorque ahead = law->torque({.target = 0.55, .q = 0, .rate = 6.5}, h);
  EXPECT_NEAR(followed_line(ahead, 1.0, 0.0).torque, 20 * 0.55 - 0.6 * 6.5 - h * 20 * 6.5, 1e-13);
  EXPECT_EQ(ahead.now, 7);
  EXPECT_GT(followed_line(ahead, 1.0, 0.0).inertia, 0);
}

TEST(IdealPd, KnowsStepsAndDeadBand) {
  Servo servo = pd();
  servo.encoder_step = 0.1;
  servo.dead_band = 0.15;
  const auto law = make_servo_law(servo);
  EXPECT_NEAR(law->torque({.target = 0.32, .q = 0.04}, 0).now, 20 * 0.15, 1e-12) << "0.3 less 0.15";
  const MotorTorque dead = law->torque({.target = 0.12, .q = 0.04, .rate = 0.5}, h);
  EXPECT_NEAR(dead.now, -0.6 * 0.5, 1e-14);
  EXPECT_NEAR(dead.free.torque, dead.now, 1e-14) << "no spring inside the dead band";
  EXPECT_NEAR(dead.free.inertia, h * 0.6, 1e-16);
}

TEST(IdealPd, WithoutPositionGainFollowsTheRate) {
  Servo servo = pd();
  servo.position_gain = 0;
  EXPECT_TRUE(follows_rate(servo));
  const MotorTorque torque = make_servo_law(servo)->torque({.target = 4, .q = 100, .rate = 1.5}, h);
  EXPECT_NEAR(torque.now, 0.6 * 2.5, 1e-14);
  EXPECT_NEAR(torque.free.torque, 0.6 * 2.5, 1e-14);
  EXPECT_NEAR(torque.free.inertia, h * 0.6, 1e-16);
}

TEST(ServoLaw, OnlyAPdWithoutPositionGainFollowsARate) {
  EXPECT_FALSE(follows_rate(pd()));
  Servo servo = pd();
  servo.position_gain = servo.velocity_gain = 0;
  EXPECT_FALSE(follows_rate(servo)) << "it does nothing";
  servo.velocity_gain = 1;
  servo.law = "dc_motor";
  EXPECT_FALSE(follows_rate(servo));
}

// Behind the gear: the motor's torque less the budget of dry friction, whose load share counts motor and load, less K_v |w|.
TEST(ServoLaw, AvailableIsWhatIsLeftBehindTheGear) {
  Servo servo = pd();
  servo.friction = {.coulomb = 0.4, .viscous = 0.25, .motor_load = 0.1, .external_load = 0.05};
  const auto law = make_servo_law(servo);
  for (const double rate : {2.0, -2.0}) {
    EXPECT_NEAR(law->available(rate, 1), 7 - (0.4 + 0.15 * 7) - 0.25 * 2, 1e-12) << rate;
  }
  EXPECT_EQ(law->available(40, 1), 0) << "never less than nothing";
  servo.stall_torque = 0;
  EXPECT_EQ(make_servo_law(pd())->available(3, -1), 7);
  servo.friction = {};
  EXPECT_EQ(make_servo_law(servo)->available(3, -1), std::numeric_limits<double>::infinity());
}

TEST(ServoLaw, MotorHasLessLeftTheFasterItRuns) {
  Servo servo{.type = "motor", .stall_torque = 6, .no_load_speed = 8, .position_gain = 30, .duty_limit = 0.9};
  const auto law = make_servo_law(servo);
  EXPECT_NEAR(law->available(0, 1), 5.4, 1e-12);
  EXPECT_NEAR(law->available(2, 1), 5.4 - 1.5, 1e-12);
  EXPECT_NEAR(law->available(2, -1), 5.4 + 1.5, 1e-12) << "driven against its torque";
  EXPECT_NEAR(law->available(-2, -1), 5.4 - 1.5, 1e-12);
  servo.torque_limit = 4;
  const auto limited = make_servo_law(servo);
  EXPECT_NEAR(limited->available(0, 1), 4, 1e-12);
  EXPECT_NEAR(limited->available(2, -1), 4, 1e-12);
  EXPECT_NEAR(limited->available(4, 1), 5.4 - 3, 1e-12);
}

TEST(ServoLaw, ReplacesTheLawAndKeepsTheDampingOfBackEmf) {
  const Servo motor{.type = "motor", .stall_torque = 6, .no_load_speed = 8, .position_gain = 30};
  EXPECT_EQ(with_law(motor, "").law, "dc_motor");
  EXPECT_EQ(with_law(motor, "dc_motor").velocity_gain, 0);
  const Servo ideal = with_law(motor, "ideal_pd");
  EXPECT_EQ(ideal.law, "ideal_pd");
  EXPECT_DOUBLE_EQ(ideal.velocity_gain, 0.75);
  EXPECT_EQ(with_law(pd(), "dc_motor").velocity_gain, 0.6);
  Servo damped = motor;
  damped.velocity_gain = 0.2;
  EXPECT_EQ(with_law(damped, "ideal_pd").velocity_gain, 0.2);
  Servo unknown = motor;
  unknown.no_load_speed = 0;
  EXPECT_EQ(with_law(unknown, "ideal_pd").velocity_gain, 0);
}

TEST(ServoLaw, RefusesUnknownLawsAndMotorsWithoutNumbers) {
  const auto error = [](const Servo& servo) { return fixtures::error_of([&] { (void)make_servo_law(servo); }); };
  Servo servo = pd();
  EXPECT_EQ(error(servo), "no error");
  servo.law = "ideal_dp";
  EXPECT_TRUE(fixtures::says(error(servo), {"servo 'pd'", "did you mean 'ideal_pd'?"}));
  for (const auto& [stall, rate] : {std::pair{0.0, 5.0}, {5.0, 0.0}, {-1.0, 5.0}}) {
    servo = {.type = "motor", .stall_torque = stall, .no_load_speed = rate};
    EXPECT_TRUE(fixtures::says(error(servo), {"'motor'", "dc_motor", "stall_torque and no_load_speed"}));
  }
}

}  // namespace
}  // namespace murosimf::dynamics
