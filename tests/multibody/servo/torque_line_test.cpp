#include "murosimf/multibody/servo/torque_line.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/math/lanes.h"
#include "murosimf/math/pack.h"
#include "tests/fixtures.h"

namespace murosimf::multibody {
namespace {

double at(const TorqueLine<double>& line, double acceleration) { return line.torque - line.inertia * acceleration; }

/// What the motor makes at an acceleration.
double made(const MotorTorque<double>& motor, double acceleration) {
  return std::clamp(at(motor.free, acceleration), at(motor.lowest, acceleration), at(motor.highest, acceleration));
}

/// Of `inertia` a = made(a) + load, by bisection: the difference of both sides rises with a.
double acceleration_by_bisection(const MotorTorque<double>& motor, double inertia, double load) {
  double low = -1e9, high = 1e9;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (inertia * middle < made(motor, middle) + load ? low : high) = middle;
  }
  return low;
}

MotorTorque<double> random_motor(fixtures::Dice& dice) {
  MotorTorque<double> motor;
  motor.free = {dice.uniform(-20, 20), dice.uniform(0, 0.1)};
  motor.highest = {dice.uniform(0, 10), dice.chance(0.5) ? 0 : dice.uniform(0, 0.02)};
  motor.lowest = {-dice.uniform(0, 10), motor.highest.inertia};
  if (dice.chance(0.2)) motor.highest = {MotorTorque<double>::unbounded};
  return motor;
}

TEST(TorqueLine, IsTheOneOfTheTrueAcceleration) {
  fixtures::Dice dice("torque_line");
  int free = 0, bounded = 0;
  for (int i = 0; i < 2000; ++i) {
    const MotorTorque<double> motor = random_motor(dice);
    const double inertia = dice.uniform(1e-4, 0.1), load = dice.uniform(-10, 10);
    const double D = inertia + motor.free.inertia;
    const TorqueLine<double> line = followed_line(motor, D, motor.free.torque + load);
    const double acceleration = (line.torque + load) / (inertia + line.inertia);
    EXPECT_NEAR(acceleration, acceleration_by_bisection(motor, inertia, load),
                1e-6 * std::max(1.0, std::abs(acceleration)));
    ++(line.inertia == motor.free.inertia && line.torque == motor.free.torque ? free : bounded);
  }
  EXPECT_GT(free, 300);
  EXPECT_GT(bounded, 300);
}

TEST(TorqueLine, HasTheSameBitsInLanes) {
  fixtures::Dice dice("torque_line in lanes");
  for (int i = 0; i < 50; ++i) {
    MotorTorque<Pack8> motors;
    Pack8 D, push;
    std::array<TorqueLine<double>, Pack8::lanes> expected;
    for (int lane = 0; lane < Pack8::lanes; ++lane) {
      const MotorTorque<double> motor = random_motor(dice);
      const double inertia = dice.uniform(1e-3, 1), load = dice.uniform(-20, 20);
      set_lane(motors, lane, motor);
      D.set_lane(lane, inertia);
      push.set_lane(lane, load);
      expected[static_cast<std::size_t>(lane)] = followed_line(motor, inertia, load);
    }
    const TorqueLine<Pack8> found = followed_line(motors, D, push);
    for (int lane = 0; lane < Pack8::lanes; ++lane) {
      EXPECT_EQ(found.torque.lane(lane), expected[static_cast<std::size_t>(lane)].torque);
      EXPECT_EQ(found.inertia.lane(lane), expected[static_cast<std::size_t>(lane)].inertia);
    }
  }
}

TEST(TorqueLine, OfAMotorWithoutLimitsIsItsFreeOne) {
  const MotorTorque<double> motor{.now = 1, .free = {3, 0.2}};
  const TorqueLine<double> line = followed_line(motor, 0.01, -1e12);
  EXPECT_EQ(line.torque, 3);
  EXPECT_EQ(line.inertia, 0.2);
}

}  // namespace
}  // namespace murosimf::multibody
