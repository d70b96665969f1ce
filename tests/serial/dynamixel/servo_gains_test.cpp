// What gains, limits and the LED in a servo's registers mean, by the formulas of the e-Manual.
#include <tuple>

#include <gtest/gtest.h>

#include "murosimf/serial/dynamixel/servo_device.h"

namespace murosimf::serial::dynamixel {
namespace {

struct Bench {
  explicit Bench(const std::string& table) : servo(*find_servo_table(table), 1, {.full_error = 0.3, .torque = true}) {
    servo.sense({}, 0);
  }
  Refusal write(std::size_t address, int value, std::size_t size) {
    Bytes bytes;
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFF));
    return servo.write(address, bytes);
  }
  ServoDevice servo;
};

TEST(ServoGains, AreTheFactorysAtFirst) {
  for (const std::string& name : servo_table_names()) {
    const Bench bench(name);
    EXPECT_EQ(bench.servo.gain_share(), 1) << name;
    EXPECT_EQ(bench.servo.damping_time(), 0) << name;
    EXPECT_EQ(bench.servo.torque_share(), 1) << name;
    EXPECT_FALSE(bench.servo.led()) << name;
  }
}

TEST(ServoGains, AreThoseOfTheRegisters) {
  Bench old("mx28");
  EXPECT_EQ(old.write(28, 8, 1), Refusal::none);
  EXPECT_EQ(old.servo.gain_share(), 0.25);
  EXPECT_EQ(old.write(26, 50, 1), Refusal::none);
  EXPECT_NEAR(old.servo.damping_time(), 50 * 4 / 1000.0 / (32 / 8.0), 1e-15);
  EXPECT_EQ(old.write(34, 511, 2), Refusal::none);
  EXPECT_NEAR(old.servo.torque_share(), 511 / 1023.0, 1e-15);
  EXPECT_EQ(old.write(25, 1, 1), Refusal::none);
  EXPECT_TRUE(old.servo.led());

  Bench modern("xm430_w350");
  EXPECT_EQ(modern.write(84, 1600, 2), Refusal::none);
  EXPECT_EQ(modern.servo.gain_share(), 2);
  EXPECT_EQ(modern.write(80, 400, 2), Refusal::none);
  EXPECT_NEAR(modern.servo.damping_time(), 400 / 16.0 * 1e-3 / (800 / 128.0), 1e-15);
  EXPECT_EQ(modern.write(100, 442, 2), Refusal::none);
  EXPECT_NEAR(modern.servo.torque_share(), 442 / 885.0, 1e-15);
  EXPECT_EQ(modern.write(65, 1, 1), Refusal::none);
  EXPECT_TRUE(modern.servo.led());
}

TEST(ServoGains, AGoalCurrentLimitsInItsModeOnly) {
  Bench bench("xm430_w350");
  EXPECT_EQ(bench.write(102, 100, 2), Refusal::none);
  EXPECT_EQ(bench.servo.torque_share(), 1);
  EXPECT_EQ(bench.write(64, 0, 1), Refusal::none);
  EXPECT_EQ(bench.write(11, 5, 1), Refusal::none);
  EXPECT_EQ(bench.servo.torque_share(), 1) << "a change of the mode sets it to Current Limit";
  EXPECT_EQ(bench.write(102, 100, 2), Refusal::none);
  EXPECT_NEAR(bench.servo.torque_share(), 100 * 0.00269 / 2.3, 1e-12);
  Bench without("mx28_2");
  EXPECT_EQ(without.write(64, 0, 1), Refusal::none);
  EXPECT_EQ(without.write(11, 5, 1), Refusal::range) << "it measures no current";
}

// An error of 100 pulses that stays: the target moves on by Ki/Kp of its integral, and no further than what gives all torque.
TEST(ServoGains, AnIntegralGainMovesTheTarget) {
  for (const auto& [table, address, size, value, per_second] :
       std::vector<std::tuple<std::string, std::size_t, std::size_t, int, double>>{
           {"mx28", 27, 1, 4, 4 * 1000 / 2048.0 / (32 / 8.0)},
           {"mx28_2", 82, 2, 500, 500 * 1000 / 65536.0 / (850 / 128.0)}}) {
    Bench bench(table);
    const bool old = size == 1;
    EXPECT_EQ(bench.write(old ? 30 : 116, 2148, old ? 2 : 4), Refusal::none);
    const double error = 100 / 4096.0 * 2 * 3.14159265358979;
    bench.servo.advance(0.001);
    EXPECT_NEAR(bench.servo.target(), error, 1e-12);
    EXPECT_EQ(bench.write(address, value, size), Refusal::none);
    for (int i = 0; i < 500; ++i) bench.servo.advance(0.001);
    EXPECT_NEAR(bench.servo.target(), error * (1 + 0.5 * per_second), 1e-9) << table;
    for (int i = 0; i < 100'000; ++i) bench.servo.advance(0.001);
    EXPECT_NEAR(bench.servo.target(), error + 0.3, 1e-9) << table;
    EXPECT_EQ(bench.write(old ? 24 : 64, 0, 1), Refusal::none);
    bench.servo.advance(0.001);
    EXPECT_NEAR(bench.servo.target(), 0, 1e-9) << "without torque nothing is left of it";
  }
}

}  // namespace
}  // namespace murosimf::serial::dynamixel
