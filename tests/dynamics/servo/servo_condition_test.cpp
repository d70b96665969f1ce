// What motors have before them: supply, switch, temperature, by the numbers of each servo.
#include "murosimf/dynamics/servo/servo_condition.h"

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "tests/dynamics/part.h"
#include "tests/fixtures.h"

namespace murosimf::dynamics {
namespace {

Servo warm_servo(double ambient) {
  return {.type = "warm",
          .voltage = 12,
          .stall_torque = 6,
          .no_load_speed = 8,
          .position_gain = 30,
          .heat = {.heat_capacity = 40,
                   .thermal_resistance = 5,
                   .ambient_temperature = ambient,
                   .derating_temperature = 60,
                   .temperature_limit = 80}};
}

Chain three_servos() {
  return Chain{}
      .base("base")
      .revolute("bare", {0, 1, 0})
      .revolute("plain", {0, 1, 0})
      .with(properties::servo, {.type = "plain", .voltage = 15, .stall_torque = 3, .no_load_speed = 5})
      .revolute("unknown", {0, 1, 0})
      .with(properties::servo, {.type = "unknown", .stall_torque = 3, .no_load_speed = 5})
      .revolute("warm", {0, 1, 0})
      .with(properties::servo, warm_servo(20))
      .revolute("warmer", {0, 1, 0})
      .with(properties::servo, warm_servo(35));
}

struct Servos : test::Alone<ServoCondition> {
  explicit Servos(std::string_view law = {}) : Alone(three_servos(), law) {}
  [[nodiscard]] MotorInput fill(const char* name) const {
    MotorInput input;
    part->fill(index(name), input);
    return input;
  }
  [[nodiscard]] double temperature(const char* name) { return object(name).get(properties::servo_temperature); }
};

TEST(ServoCondition, SupplyIsAShareOfEachServosVoltage) {
  Servos servos;
  EXPECT_EQ(servos.object("plain").get(properties::supply_voltage), 15);
  EXPECT_EQ(servos.object("warm").get(properties::supply_voltage), 12);
  EXPECT_EQ(servos.object("bare").get(properties::supply_voltage), 0);
  EXPECT_EQ(servos.fill("plain").supply, 1);
  servos.object("plain").set(properties::supply_voltage, 9);
  servos.object("unknown").set(properties::supply_voltage, 9);
  EXPECT_DOUBLE_EQ(servos.fill("plain").supply, 0.6);
  EXPECT_EQ(servos.fill("unknown").supply, 1) << "its voltage is not known";
}

TEST(ServoCondition, TorqueIsOnUntilItIsSwitchedOff) {
  Servos servos;
  EXPECT_EQ(servos.fill("plain").enabled, 1);
  servos.object("plain").set(properties::torque_enabled, 0);
  EXPECT_EQ(servos.fill("plain").enabled, 0);
  EXPECT_EQ(servos.fill("warm").enabled, 1);
}

TEST(ServoCondition, ServosStartAtTheTemperatureOfTheirAir) {
  Servos servos;
  EXPECT_FALSE(servos.part->heats(servos.index("plain")));
  EXPECT_TRUE(servos.part->heats(servos.index("warm")));
  servos.part->take_over();
  EXPECT_EQ(servos.temperature("warm"), 20);
  EXPECT_EQ(servos.temperature("warmer"), 35);
  servos.object("warm").set(properties::servo_temperature, 70);
  EXPECT_EQ(servos.fill("warm").allowed, 0.5);
  EXPECT_NEAR(servos.fill("warm").conductance, 1 / (1 + 0.0039 * 45), 1e-15);
  EXPECT_EQ(servos.fill("warmer").allowed, 1);
  EXPECT_EQ(servos.fill("plain").conductance, 1);
  servos.part->cool_down();
  EXPECT_EQ(servos.temperature("warm"), 20);
}

// C dT/dt = R i^2 - (T - T_a) / R_th, R = k_t V / stall, k_t = V / no-load rate.
TEST(ServoCondition, TorqueWarmsTheWinding) {
  Servos servos;
  servos.part->cool_down();
  const double k_t = 12.0 / 8, R = k_t * 12 / 6, i = 2 / k_t, losses = R * i * i * (1 + 0.0039 * (20 - 25));
  servos.part->warm(servos.index("warm"), -2, 0.001);
  EXPECT_NEAR(servos.temperature("warm") - 20, 0.001 / 40 * losses, 1e-8);
  EXPECT_EQ(servos.temperature("warmer"), 35);
}

TEST(ServoCondition, IdealServosStayCool) {
  Servos servos("ideal_pd");
  EXPECT_FALSE(servos.part->heats(servos.index("warm")));
  EXPECT_EQ(servos.fill("warm").allowed, 1);
}

TEST(ServoCondition, HeatNeedsAVoltage) {
  Servo servo = warm_servo(20);
  servo.voltage = 0;
  const Chain chain = Chain{}.base("base").revolute("joint", {0, 1, 0}).with(properties::servo, servo);
  EXPECT_TRUE(fixtures::says(fixtures::error_of([&] { test::Alone<ServoCondition> robot(chain, std::string_view{}); }),
                             {"'warm'", "voltage"}));
}

}  // namespace
}  // namespace murosimf::dynamics
