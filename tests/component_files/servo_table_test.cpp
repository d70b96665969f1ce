/// servo_table_test - every ready-made servo can be read, is plausible, and has the numbers that its comments derive.
#include "murosimf/component_files/servo_table.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::component_files {
namespace {

const std::vector<std::string> shipped{"mx106", "mx28", "mx64", "xl330", "xl330_m4", "xm430_w350"};

TEST(ServoTable, NamesAllThatCome) {
  const auto types = servo_types();
  for (const std::string& type : shipped) EXPECT_NE(std::find(types.begin(), types.end(), type), types.end()) << type;
}

void expect_between(double value, double low, double high) {
  EXPECT_GE(value, low);
  EXPECT_LE(value, high);
}

/// Wide bounds for servos of 18 to 153 g: they find slips of a unit or of the gear's side, not of a digit.
TEST(ServoTable, ShippedServosArePlausible) {
  for (const std::string& type : servo_types()) {
    SCOPED_TRACE(type);
    const Servo servo = read_servo(type);
    EXPECT_EQ(servo.type, type);
    EXPECT_EQ(servo.law, "dc_motor");
    expect_between(servo.voltage, 3, 24);
    expect_between(servo.no_load_speed, 2, 40);
    expect_between(0.25 * servo.stall_torque * servo.no_load_speed, 0.5, 50);                    // [W] largest power
    expect_between(servo.stall_torque * servo.no_load_speed / servo.voltage, 0.5, 10);           // [A] at stall
    expect_between(servo.stall_torque / servo.position_gain, 0.05, 1.5);                         // [rad] to full duty
    expect_between(servo.rotor_inertia * servo.no_load_speed / servo.stall_torque, 0.002, 0.2);  // [s] to run up
    expect_between((servo.friction.coulomb + servo.friction.stribeck) / servo.stall_torque, 0.002, 0.2);
    expect_between(servo.friction.viscous * servo.no_load_speed / servo.stall_torque, 0, 0.2);
    expect_between(servo.duty_limit, 0.5, 1);
    EXPECT_EQ(servo.velocity_gain, 0);
  }
}

/// Numbers in the comments of the fitted servos' files. Tolerance: they are written with four digits.
void expect_fitted(const std::string& type, double k_t, double R, double voltage, double duty_per_rad) {
  SCOPED_TRACE(type);
  const Servo servo = read_servo(type);
  const auto near = [](double value, double expected) { EXPECT_NEAR(value / expected, 1, 2e-4); };
  near(servo.voltage, voltage);
  near(servo.stall_torque, k_t * voltage / R);
  near(servo.no_load_speed, voltage / k_t);
  near(servo.position_gain, k_t * voltage / R * duty_per_rad);
}

TEST(ServoTable, FittedServosAreWhatTheirFilesDerive) {
  expect_fitted("mx64", 1.622, 3.949, 12, 0.158 * 32);
  expect_fitted("mx106", 2.191, 2.965, 12, 0.158 * 32);
  expect_fitted("xl330", 0.3867, 4.017, 5, 4096 / (2 * pi) / (256 * 885) * 400);
  const Servo servo = read_servo("mx64");
  EXPECT_EQ(servo.duty_limit, 0.9625);
  EXPECT_EQ(servo.rotor_inertia, 0.01195);
  EXPECT_EQ(servo.friction.coulomb, 0.09039);
  EXPECT_EQ(servo.friction.viscous, 0.01169);
}

/// Fits and data sheets come from different sources; the largest differences are 20 % (no-load rate of the xl330, without
/// friction in the fit and with it in the sheet) and 18 % (stall torque of the mx64).
TEST(ServoTable, ShippedServosAgreeWithTheirDataSheets) {
  struct Sheet {
    const char* type;
    double stall_torque, rev_per_min;
  };
  for (const auto& [type, torque, speed] : {Sheet{"mx28", 2.5, 55}, Sheet{"mx64", 6.0, 63}, Sheet{"mx106", 8.4, 45},
                                            Sheet{"xl330", 0.52, 103}, Sheet{"xm430_w350", 4.1, 46}}) {
    SCOPED_TRACE(type);
    const Servo servo = read_servo(type);
    EXPECT_NEAR(servo.stall_torque / torque, 1, 0.25);
    EXPECT_NEAR(servo.no_load_speed / (speed * pi / 30), 1, 0.25);
  }
}

TEST(ServoTable, NamesTheNearestType) {
  try {
    (void)read_servo("mx65");
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_STREQ(error.what(), "unknown servo type 'mx65'; did you mean 'mx64'?");
  }
}

}  // namespace
}  // namespace murosimf::component_files
