// What servos do by the e-Manual besides going to positions: indirect addresses, the bus watchdog, turns, duty, overload, profiles,
// modes, drive modes, starting again.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "murosimf/serial/dynamixel/servo_device.h"

namespace murosimf::serial::dynamixel {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
constexpr double one_rpm = full_turn / 60;

struct ModeBench {
  explicit ModeBench(const std::string& table, const ServoOptions& options = {})
      : servo(*find_servo_table(table), 1, options) {
    servo.sense({}, 0);
  }
  Refusal write(std::size_t address, int value, std::size_t size) {
    Bytes bytes;
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i) & 0xFF));
    return servo.write(address, bytes);
  }
  Bytes read(std::size_t address, std::size_t size) {
    const auto answer = servo.read(address, size);
    if (!answer) return {};
    const auto skip = servo.protocol() == Protocol::v2 ? 1 : 0;
    return {answer->parameters.begin() + skip, answer->parameters.end()};
  }
  int number(std::size_t address, std::size_t size) {
    const Bytes data = read(address, size);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < data.size(); ++i) bits |= std::uint32_t{data[i]} << 8 * i;
    if (size == 2) return static_cast<std::int16_t>(bits);
    return static_cast<std::int32_t>(bits);
  }
  std::uint8_t error() { return servo.ping()->parameters.at(0); }
  void wait(double time, double step = 0.001) {
    for (double t = 0; t < time - 1e-9; t += step) servo.advance(step);
  }
  ServoDevice servo;
};

TEST(IndirectAddresses, ReadAndWriteWhatTheyPointTo) {
  ModeBench bench("xm430_w350", {.torque = true});
  bench.servo.sense({.angle = full_turn / 8}, 0);
  EXPECT_EQ(bench.number(168, 2), 224);                                                        // from the factory
  for (int i = 0; i < 4; ++i) EXPECT_EQ(bench.write(168 + 2 * i, 132 + i, 2), Refusal::none);  // present position
  EXPECT_EQ(bench.write(176, 65, 2), Refusal::none);                                           // LED
  for (int i = 0; i < 4; ++i) EXPECT_EQ(bench.write(578 + 2 * i, 116 + i, 2), Refusal::none);  // goal position
  EXPECT_EQ(bench.number(224, 4), 2048 + 512);
  EXPECT_EQ(bench.write(228, 1, 1), Refusal::none);
  EXPECT_TRUE(bench.servo.led());
  EXPECT_EQ(bench.read(224, 6), (Bytes{0x00, 0x0A, 0, 0, 1, 0}));
  EXPECT_EQ(bench.write(634, 3000, 4), Refusal::none);
  bench.servo.advance(0.001);
  EXPECT_NEAR(bench.servo.target(), (3000 - 2048) * full_turn / 4096, 1e-9);
  EXPECT_EQ(bench.write(634, 5000, 4), Refusal::limit) << "limits are those of the goal";
  EXPECT_EQ(bench.write(224, 1, 1), Refusal::access) << "a present position cannot be written";
  EXPECT_EQ(bench.write(634, 1, 2), Refusal::length) << "half a goal";
  EXPECT_EQ(bench.write(168, 63, 2), Refusal::range);
  EXPECT_EQ(bench.write(168, 662, 2), Refusal::range);
  EXPECT_EQ(bench.write(240, 77, 1), Refusal::none);  // points to itself
  EXPECT_EQ(bench.number(240, 1), 77);
}

TEST(IndirectAddresses, AreWhereTheModelHasThem) {
  EXPECT_EQ(ModeBench("xl330_m288").number(168, 2), 208);
  EXPECT_EQ(ModeBench("xl330_m288").number(206, 2), 227);
  EXPECT_EQ(ModeBench("xl330_m288").write(168, 228, 2), Refusal::range);
  EXPECT_EQ(ModeBench("xl430_w250").number(632, 2), 661);
  EXPECT_TRUE(ModeBench("mx28").read(168, 2).empty());
}

TEST(BusWatchdog, StopsAServoThatNobodyTalksTo) {
  ModeBench bench("xm430_w350", {.torque = true});
  EXPECT_EQ(bench.write(98, 2, 1), Refusal::none);  // 40 ms
  EXPECT_EQ(bench.write(112, 20, 4), Refusal::none);
  EXPECT_EQ(bench.write(116, 4000, 4), Refusal::none);
  for (int i = 0; i < 10; ++i) {
    bench.wait(0.03);
    bench.servo.heard();
  }
  EXPECT_EQ(bench.number(98, 1), 2);
  bench.wait(0.039);
  EXPECT_EQ(bench.number(98, 1), 2);
  bench.wait(0.003);
  EXPECT_EQ(bench.number(98, 1), 255);
  const double stopped = bench.servo.target();
  bench.wait(0.5);
  EXPECT_EQ(bench.servo.target(), stopped);
  EXPECT_TRUE(bench.servo.torque());
  for (const auto& [address, size] :
       std::vector<std::pair<std::size_t, std::size_t>>{{100, 2}, {102, 2}, {104, 4}, {108, 4}, {112, 4}, {116, 4}}) {
    EXPECT_EQ(bench.write(address, 1, size), Refusal::range) << address;
  }
  EXPECT_EQ(bench.write(98, 128, 1), Refusal::range);
  EXPECT_EQ(bench.write(98, 255, 1), Refusal::range);
  EXPECT_EQ(bench.write(98, 0, 1), Refusal::none);
  EXPECT_EQ(bench.write(116, 3000, 4), Refusal::none);
  bench.wait(1);
  EXPECT_EQ(bench.number(98, 1), 0);
}

TEST(BusWatchdog, StopsAWheel) {
  ModeBench bench("xl430_w250");
  EXPECT_EQ(bench.write(11, 1, 1), Refusal::none);
  EXPECT_EQ(bench.write(64, 1, 1), Refusal::none);
  EXPECT_EQ(bench.write(98, 5, 1), Refusal::none);
  EXPECT_EQ(bench.write(104, 100, 4), Refusal::none);
  bench.wait(0.1);
  EXPECT_GT(bench.servo.target_velocity(), 0);
  bench.wait(0.01);
  EXPECT_EQ(bench.servo.target_velocity(), 0);
}

TEST(Turns, AreForgottenWhenAClientSaysSoAndAtAStart) {
  ModeBench bench("xm430_w350");
  EXPECT_EQ(bench.write(11, 4, 1), Refusal::none);
  const auto stand = [&](double pulses) { bench.servo.sense({.angle = (pulses - 2048) * full_turn / 4096}, 1); };
  stand(9000);
  EXPECT_EQ(bench.number(132, 4), 9000);
  Packet clear{Protocol::v2, 1, static_cast<std::uint8_t>(Instruction::clear), {0x01, 0x44, 0x58, 0x4C, 0x22}};
  EXPECT_EQ(bench.servo.execute(clear)->parameters.at(0), 0);
  EXPECT_EQ(bench.number(132, 4), 808);
  stand(9100);
  EXPECT_EQ(bench.number(132, 4), 908);
  EXPECT_EQ(bench.write(64, 1, 1), Refusal::none);
  EXPECT_EQ(bench.write(116, 1000, 4), Refusal::none);
  bench.servo.advance(0.001);
  EXPECT_NEAR(bench.servo.target(), (9192 - 2048) * full_turn / 4096, 1e-9) << "it goes on from where it is";
  stand(-3000);
  EXPECT_EQ(bench.number(132, 4), -3000 - 8192);
  const Packet reboot{Protocol::v2, 1, static_cast<std::uint8_t>(Instruction::reboot), {}};
  (void)bench.servo.execute(reboot);
  stand(-3000);
  EXPECT_EQ(bench.number(132, 4), 1096);
  clear.parameters[1] = 0;
  EXPECT_EQ(bench.servo.execute(clear)->parameters.at(0), error_v2::data_range);
  bench.servo.sense({.angle = 20, .velocity = 3}, 1);  // it moves
  clear.parameters[1] = 0x44;
  EXPECT_EQ(bench.servo.execute(clear)->parameters.at(0), error_v2::result_fail);
}

// u = M / M_stall + w / w_no_load
TEST(PresentPwm, IsTheDutyThatTorqueAndSpeedTake) {
  ModeBench bench("xm430_w350", {.stall_torque = 4, .no_load_speed = 5, .torque = true});
  bench.servo.sense({.velocity = 1, .torque = 1}, 0);
  EXPECT_EQ(bench.number(124, 2), std::lround(885 * 0.45));
  bench.servo.sense({.velocity = -4, .torque = -2}, 0);
  EXPECT_EQ(bench.number(124, 2), -885);
  EXPECT_EQ(bench.write(64, 0, 1), Refusal::none);
  bench.servo.sense({.velocity = 1, .torque = 1}, 0);
  EXPECT_EQ(bench.number(124, 2), 0) << "an open bridge";
}

TEST(Overload, SwitchesTheTorqueOffUntilTheServoStartsAgain) {
  ModeBench bench("xm430_w350", {.stall_torque = 4, .torque = true});
  const auto push = [&](double torque, double time) {
    for (double t = 0; t < time; t += 0.001) {
      bench.servo.sense({.torque = torque}, t);
      bench.servo.advance(0.001);
    }
    bench.servo.sense({.torque = torque}, 0);
  };
  push(3.5, 3);
  EXPECT_TRUE(bench.servo.torque()) << "as much it can";
  push(3.9, 0.9);
  push(1.0, 0.1);
  push(-3.9, 0.9);
  EXPECT_TRUE(bench.servo.torque()) << "for a moment";
  EXPECT_EQ(bench.error(), 0);
  push(-3.9, 0.2);
  EXPECT_FALSE(bench.servo.torque());
  EXPECT_EQ(bench.number(70, 1), 0x20);
  EXPECT_EQ(bench.error(), error_v2::alert);
  EXPECT_EQ(bench.write(64, 1, 1), Refusal::failed);
  (void)bench.servo.execute({Protocol::v2, 1, static_cast<std::uint8_t>(Instruction::reboot), {}});
  EXPECT_FALSE(bench.servo.hears(0));
  bench.wait(BusDevice::start_time);
  EXPECT_TRUE(bench.servo.hears(0));
  EXPECT_EQ(bench.write(64, 1, 1), Refusal::none);
  EXPECT_EQ(bench.error(), 0);
}

TEST(Profile, AcceleratesAndBrakes) {
  ModeBench bench("xm430_w350", {.torque = true});
  const double rise = 10 * 214.577 * full_turn / 3600, speed = 100 * 0.229 * one_rpm;  // 3.75 rad/s^2, 2.40 rad/s
  EXPECT_EQ(bench.write(108, 10, 4), Refusal::none);
  EXPECT_EQ(bench.write(112, 100, 4), Refusal::none);
  EXPECT_EQ(bench.write(116, 2048 + 2000, 4), Refusal::none);
  bench.wait(0.2);
  EXPECT_NEAR(bench.servo.target(), 0.5 * rise * 0.2 * 0.2, 0.001);
  const double way = 2000 * full_turn / 4096, all = way / speed + speed / rise;  // a trapezoid
  bench.wait(0.5 * all - 0.2);
  EXPECT_NEAR(bench.servo.target(), way / 2, 0.01);
  EXPECT_EQ(bench.number(136, 4), 100);
  bench.wait(0.5 * all - 0.05);
  EXPECT_LT(bench.servo.target(), way);
  bench.wait(0.1);
  EXPECT_NEAR(bench.servo.target(), way, 1e-9);
  EXPECT_EQ(bench.number(136, 4), 0);
}

TEST(Profile, OfTimesTakesThem) {
  ModeBench bench("xm430_w350");
  EXPECT_EQ(bench.write(10, 4, 1), Refusal::none);
  EXPECT_EQ(bench.write(64, 1, 1), Refusal::none);
  for (const int rise : {0, 300}) {
    EXPECT_EQ(bench.write(108, rise, 4), Refusal::none);
    EXPECT_EQ(bench.write(112, 1000, 4), Refusal::none);
    const double begin = bench.servo.target();
    const int goal = rise == 0 ? 3000 : 1000;
    EXPECT_EQ(bench.write(116, goal, 4), Refusal::none);
    const double end = (goal - 2048) * full_turn / 4096;
    bench.wait(0.5);
    EXPECT_NEAR(bench.servo.target(), 0.5 * (begin + end), 0.01) << rise;
    bench.wait(0.48);
    EXPECT_GT(std::abs(bench.servo.target() - end), 1e-6) << rise;
    bench.wait(0.06);
    EXPECT_NEAR(bench.servo.target(), end, 1e-9) << rise;
  }
}

TEST(DriveMode, TurnsTheOtherWayRound) {
  ModeBench bench("xm430_w350", {.lowest = -0.5, .highest = 1.0});
  EXPECT_EQ(bench.write(10, 1, 1), Refusal::none);
  bench.servo.sense({.angle = 0.25, .velocity = 1, .torque = 2}, 0);
  EXPECT_EQ(bench.number(132, 4), 2048 - 163);
  EXPECT_LT(bench.number(128, 4), 0);
  EXPECT_LT(bench.number(126, 2), 0);
  EXPECT_EQ(bench.write(64, 1, 1), Refusal::none);
  EXPECT_EQ(bench.write(116, 2048 - 400, 4), Refusal::none);
  bench.servo.advance(0.001);
  EXPECT_NEAR(bench.servo.target(), 400 * full_turn / 4096, 1e-9);
  EXPECT_EQ(bench.write(116, 4095, 4), Refusal::none);
  bench.servo.advance(0.001);
  EXPECT_NEAR(bench.servo.target(), -0.5, 1e-9) << "where it ends";
  EXPECT_EQ(bench.write(10, 0, 1), Refusal::access) << "while the torque is on";
  EXPECT_EQ(ModeBench("xm430_w350").write(10, 2, 1), Refusal::range) << "no second servo";
}

TEST(DriveMode, AGoalSwitchesTheTorqueOn) {
  ModeBench bench("xm430_w350");
  EXPECT_EQ(bench.write(10, 8, 1), Refusal::none);
  EXPECT_EQ(bench.write(116, 3000, 4), Refusal::none);
  EXPECT_TRUE(bench.servo.torque());
  bench.servo.advance(0.001);
  EXPECT_NEAR(bench.servo.target(), (3000 - 2048) * full_turn / 4096, 1e-9);
}

TEST(OperatingMode, CurrentAndPwmPushAsHardAsTheySay) {
  ModeBench bench("xm430_w350", {.lowest = -3, .highest = 3});
  EXPECT_EQ(bench.write(11, 0, 1), Refusal::none);
  EXPECT_EQ(bench.number(102, 2), 0) << "it begins at rest";
  EXPECT_EQ(bench.write(64, 1, 1), Refusal::none);
  EXPECT_EQ(bench.write(102, -200, 2), Refusal::none);
  bench.servo.advance(0.001);
  EXPECT_EQ(bench.servo.target(), -3);
  EXPECT_NEAR(bench.servo.torque_share(), 200 * 0.00269 / 2.3, 1e-12);
  EXPECT_EQ(bench.write(102, 1194, 2), Refusal::range);
  bench.servo.sense({.angle = 0.5, .driven = false}, 0);  // no level computes a motion from the torque
  bench.servo.advance(0.001);
  EXPECT_NEAR(bench.servo.target(), 0.5, 1e-9);
  bench.servo.sense({.angle = 0.5}, 0);
  EXPECT_EQ(bench.write(64, 0, 1), Refusal::none);
  EXPECT_EQ(bench.write(11, 16, 1), Refusal::none);
  EXPECT_EQ(bench.number(100, 2), 0);
  EXPECT_EQ(bench.write(64, 1, 1), Refusal::none);
  EXPECT_EQ(bench.write(100, 442, 2), Refusal::none);
  bench.servo.advance(0.001);
  EXPECT_EQ(bench.servo.target(), 3);
  EXPECT_NEAR(bench.servo.torque_share(), 442 / 885.0, 1e-12);
  EXPECT_EQ(bench.write(64, 0, 1), Refusal::none);
  EXPECT_EQ(bench.write(36, 300, 2), Refusal::none);
  EXPECT_EQ(bench.write(100, 301, 2), Refusal::limit);
  EXPECT_EQ(ModeBench("mx28_2").write(11, 0, 1), Refusal::range) << "it measures no current";
}

TEST(Feetech, CountsWithSigns) {
  ModeBench bench("sts3215");
  EXPECT_EQ(bench.number(3, 2), 777);
  bench.servo.sense({.angle = -full_turn / 8, .velocity = -1, .torque = -1.47}, 0);
  EXPECT_EQ(bench.number(56, 2), 2048 - 512);
  EXPECT_EQ(bench.number(58, 2) & 0xFFFF, 0x8000 | 652);  // 4096 / (2 pi) a second
  EXPECT_EQ(bench.number(60, 2), 0x400 | 500);
  EXPECT_EQ(bench.number(62, 1), 120);
  EXPECT_EQ(bench.number(69, 2) & 0xFFFF, 0x8000 | 208);      // 1.35 A in 6.5 mA
  EXPECT_EQ(bench.write(31, 0x800 | 100, 2), Refusal::none);  // homing offset: -100
  bench.servo.sense({.angle = -full_turn / 8}, 0);
  EXPECT_EQ(bench.number(56, 2), 2048 - 512 + 100);
  EXPECT_EQ(bench.write(42, 1700, 2), Refusal::none);
  EXPECT_TRUE(bench.servo.torque());
  bench.servo.advance(0.01);
  EXPECT_NEAR(bench.servo.target(), (1600 - 2048) * full_turn / 4096, 1e-9);
  EXPECT_EQ(bench.write(33, 1, 1), Refusal::none);
  EXPECT_EQ(bench.write(46, 0x8000 | 1000, 2), Refusal::none);
  EXPECT_NEAR(bench.servo.target_velocity(), -1000 * full_turn / 4096, 1e-9);
  EXPECT_EQ(bench.write(33, 2, 1), Refusal::range);
}

TEST(Feetech, SwitchesOffWhereItsRegistersSay) {
  ModeBench bench("sts3215", {.stall_torque = 3, .torque = true});
  EXPECT_EQ(bench.write(36, 50, 1), Refusal::none);
  EXPECT_EQ(bench.write(35, 20, 1), Refusal::none);  // 0.2 s
  for (int i = 0; i < 190; ++i) bench.servo.sense({.torque = 1.6}, 0), bench.servo.advance(0.001);
  EXPECT_TRUE(bench.servo.torque());
  for (int i = 0; i < 20; ++i) bench.servo.sense({.torque = 1.6}, 0), bench.servo.advance(0.001);
  EXPECT_FALSE(bench.servo.torque());
  EXPECT_EQ(bench.number(65, 1), 0x20);
}

TEST(Ax12, Has1023StepsIn300Degrees) {
  ModeBench bench("ax12", {.torque = true});
  bench.servo.sense({.angle = -150.2 * full_turn / 360}, 0);
  EXPECT_EQ(bench.number(36, 2), 0);
  bench.servo.sense({.angle = 0}, 0);
  EXPECT_EQ(bench.number(36, 2), 512);
  EXPECT_EQ(bench.write(30, 1023, 2), Refusal::none);
  bench.servo.advance(0.001);
  EXPECT_NEAR(bench.servo.target(), 511 * 300 / 1023.0 * full_turn / 360, 1e-9);
  EXPECT_EQ(bench.write(30, 1024, 2), Refusal::range);
}

}  // namespace
}  // namespace murosimf::serial::dynamixel
