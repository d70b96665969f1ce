// The speed-torque line, what cuts it off, what a step makes of it, and how a servo gets warm: all in closed form.
#include "murosimf/multibody/servo/servo_motor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace murosimf::multibody {
namespace {

constexpr double h = 2e-3;
const ServoHeat heat{.heat_capacity = 40,
                     .thermal_resistance = 6,
                     .ambient_temperature = 21,
                     .derating_temperature = 60,
                     .temperature_limit = 80};

/// 12 V, 6 N m at rest, 8 rad/s without load: k_t = 1.5 N m/A, R = 3 ohm.
Servo servo() {
  return {.voltage = 12, .stall_torque = 6, .no_load_speed = 8, .position_gain = 30, .duty_limit = 0.9, .heat = heat};
}

MotorTorque<double> torque_of(const ServoMotor& motor, const MotorInput<double>& in) {
  return motor_torque(motor, in, h);
}

TEST(ServoMotor, NumbersFollowFromTheDataSheet) {
  Servo limited = servo();
  limited.torque_limit = 4;
  limited.encoder_step = 0.01;
  limited.dead_band = 0.02;
  const ServoMotor motor(limited);
  EXPECT_EQ(motor.gain, 30);
  EXPECT_EQ(motor.line, 0.75);
  EXPECT_NEAR(motor.most, 5.4, 1e-15);
  EXPECT_EQ(motor.torque_limit, 4);
  EXPECT_EQ(motor.warm_limit, 4);
  EXPECT_EQ(motor.encoder_step, 0.01);
  EXPECT_EQ(motor.dead_band, 0.02);
  EXPECT_EQ(motor.torque_constant, 1.5);
  EXPECT_EQ(motor.resistance, 3);
  EXPECT_EQ(motor.heat.heat_capacity, 40);
  limited.torque_limit = 0.3;
  EXPECT_EQ(ServoMotor(limited).torque_limit, 0.3) << "a small limit is one too";
  EXPECT_TRUE(std::isinf(ServoMotor(servo()).torque_limit)) << "no limit";
  EXPECT_EQ(ServoMotor(servo()).warm_limit, 6) << "then heat takes of what it has at rest";
}

// Torque now, and what a step of the acceleration a leaves of it: kp e(after) - d w(after), with the supply and the
// winding's conductance; w(after) = w + h a, q(after) = q + h w(after).
TEST(ServoMotor, StepEndsWithTheTorqueOfItsEnd) {
  const ServoMotor motor(servo());
  const MotorInput<double> in{.target = 0.1, .q = 0.03, .rate = -0.8, .supply = 0.9, .conductance = 0.8};
  const double gain = 30 * 0.9 * 0.8, d = 0.75 * 0.8;
  const MotorTorque<double> found = torque_of(motor, in);
  EXPECT_NEAR(found.now, gain * 0.07 + d * 0.8, 1e-14);
  for (const double a : {0.0, 30.0, -70.0}) {
    const double rate = -0.8 + h * a, q = 0.03 + h * rate;
    EXPECT_NEAR(found.free.torque - found.free.inertia * a, gain * (0.1 - q) - d * rate, 1e-14) << a;
  }
}

// At full duty the speed-torque line remains: 5.4 N m less what the back-EMF takes; its slope still belongs to the step.
TEST(ServoMotor, DutyLimitLeavesTheLine) {
  const ServoMotor motor(servo());
  for (const double side : {1.0, -1.0}) {
    const MotorTorque<double> found = torque_of(motor, {.target = side * 9, .q = 0, .rate = side * 2.0});
    EXPECT_NEAR(found.now, side * (5.4 - 0.75 * 2), 1e-14);
    EXPECT_NEAR(followed_line(found, 1.0, 0.0).torque, found.now, 1e-15);
    EXPECT_NEAR(followed_line(found, 1.0, 0.0).inertia, h * 0.75, 1e-15);
  }
  EXPECT_NEAR(torque_of(motor, {.target = 9, .q = 0, .rate = 0.9 * 8.0}).now, 0, 1e-14) << "0.9 of the rate";
}

// The current limit is a torque, whatever the rate, as long as the duty reaches that far: (5.4 - 4) / 0.75 = 1.87 rad/s.
TEST(ServoMotor, CurrentLimitIsATorque) {
  Servo limited = servo();
  limited.torque_limit = 4;
  const ServoMotor motor(limited);
  for (const double rate : {0.0, 1.8, -7.0}) {
    const MotorTorque<double> found = torque_of(motor, {.target = 9, .q = 0, .rate = rate});
    EXPECT_NEAR(found.now, 4, 1e-14) << rate;
    EXPECT_EQ(followed_line(found, 1.0, 0.0).inertia, 0) << "nothing falls with the rate";
  }
  EXPECT_NEAR(torque_of(motor, {.target = 9, .q = 0, .rate = 3.0}).now, 5.4 - 0.75 * 3, 1e-14);
  EXPECT_NEAR(torque_of(motor, {.target = -9, .q = 0, .rate = 0.0}).now, -4, 1e-14);
  EXPECT_NEAR(torque_of(motor, {.target = 9, .q = 0, .rate = 0.0, .allowed = 0.25}).now, 1, 1e-14) << "warm";
  const ServoMotor free(servo());
  EXPECT_NEAR(torque_of(free, {.target = 9, .q = 0, .rate = 0.0, .allowed = 0.25}).now, 1.5, 1e-14);
}

TEST(ServoMotor, OpenBridgeMakesNothing) {
  const ServoMotor motor(servo());
  const MotorTorque<double> found = torque_of(motor, {.target = 1, .q = 0, .rate = 3.0, .enabled = 0.0});
  EXPECT_EQ(found.now, 0);
  const TorqueLine<double> line = followed_line(found, 0.01, 50.0);
  EXPECT_EQ(line.torque, 0);
  EXPECT_EQ(line.inertia, 0);
}

// Steps of 0.1 rad round target and angle, each by itself; of what is left, the dead band takes its part.
TEST(ServoMotor, FirmwareCountsInSteps) {
  EXPECT_NEAR(position_error(0.1, 0.0, 0.26, -0.14), 0.3 + 0.1, 1e-15);
  EXPECT_EQ(position_error(0.0, 0.0, 0.5, 0.25), 0.25);
  EXPECT_EQ(position_error(0.0, 0.125, 0.5, 0.25), 0.125);
  EXPECT_EQ(position_error(0.0, 0.125, 0.25, 0.5), -0.125);
  EXPECT_EQ(position_error(0.0, 0.125, 0.35, 0.25), 0);
  Servo lazy = servo();
  lazy.dead_band = 0.02;
  const ServoMotor motor(lazy);
  const MotorTorque<double> inside = torque_of(motor, {.target = 0.01, .q = 0, .rate = 0.5});
  EXPECT_NEAR(inside.now, -0.75 * 0.5, 1e-15) << "only the back-EMF brakes";
  EXPECT_NEAR(inside.free.inertia, h * 0.75, 1e-15) << "and nothing grows with the angle";
  const MotorTorque<double> outside = torque_of(motor, {.target = 0.05, .q = 0, .rate = 0.0});
  EXPECT_NEAR(outside.now, 30 * 0.03, 1e-14);
  EXPECT_NEAR(outside.free.inertia, h * 0.75 + h * h * 30, 1e-15);
}

TEST(ServoMotor, WarmWindingsConductLess) {
  EXPECT_EQ(winding_conductance(25.0), 1);
  EXPECT_NEAR(winding_conductance(125.0), 1 / 1.39, 1e-15);
  EXPECT_NEAR(winding_conductance(-25.0), 1 / 0.805, 1e-15);
}

// From 60 C on it falls in proportion, down to nothing at 80 C.
TEST(ServoMotor, FirmwareAllowsLessAboveItsTemperature) {
  for (const double cool : {-10.0, 25.0, 60.0}) EXPECT_EQ(allowed_share(heat, cool), 1) << cool;
  EXPECT_NEAR(allowed_share(heat, 65.0), 0.75, 1e-15);
  EXPECT_NEAR(allowed_share(heat, 77.0), 0.15, 1e-15);
  for (const double hot : {80.0, 120.0}) EXPECT_EQ(allowed_share(heat, hot), 0) << hot;
  EXPECT_EQ(allowed_share(ServoHeat{}, 500.0), 1) << "it has no such firmware";
}

// Without current it cools with the time constant C R_th: one step of implicit Euler.
TEST(ServoMotor, CoolsToTheAir) {
  const ServoMotor motor(servo());
  const double x = 5.0 / (40 * 6);
  EXPECT_NEAR(next_temperature(motor, 70.0, 0.0, 5.0), (70 + x * 21) / (1 + x), 1e-12);
  EXPECT_NEAR(next_temperature(motor, 21.0, 0.0, 5.0), 21, 1e-12);
}

// In the end the air takes what the winding makes: (T - T_a) / R_th = R i^2 (1 + 0.0039 (T - 25)), linear in T. Tolerance:
// what is left of the transient after 50 time constants, and rounding.
TEST(ServoMotor, WarmsUntilTheAirTakesAllLosses) {
  const ServoMotor motor(servo());
  for (const double torque : {1.2, -2.1}) {
    double temperature = 21;
    for (int i = 0; i < 20000; ++i) temperature = next_temperature(motor, temperature, torque, 1.0);
    const double i = torque / 1.5, losses = 3 * i * i;
    EXPECT_NEAR(temperature, (21.0 / 6 + losses * (1 - 0.0039 * 25)) / (1.0 / 6 - losses * 0.0039), 1e-9) << torque;
  }
}

}  // namespace
}  // namespace murosimf::multibody
