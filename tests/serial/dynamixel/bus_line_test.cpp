// Bytes in, bytes out: at once, or in the time that a baud rate gives them.
#include "murosimf/serial/dynamixel/bus_line.h"

#include <gtest/gtest.h>

#include "murosimf/serial/dynamixel/servo_device.h"

namespace murosimf::serial::dynamixel {
namespace {

struct TestLine {
  explicit TestLine(double baud_rate) : line(bus, baud_rate) {
    for (const std::uint8_t id : {1, 2}) {
      bus.add(std::make_unique<ServoDevice>(*find_servo_table("xm430_w350"), id, ServoOptions{}));
    }
  }
  Bytes run(double now) {
    Bytes out;
    line.run(now, out);
    return out;
  }
  Bus bus;
  BusLine line;
};

const Packet ping{Protocol::v2, 1, 0x01, {}};                             // 10 bytes, its answer 14
const Packet sync_read{Protocol::v2, 0xFE, 0x82, {0x84, 0, 4, 0, 1, 2}};  // 16 bytes, each answer 15
constexpr double microsecond = 1e-6, return_delay = 500 * microsecond;    // as from the factory

TEST(BusLine, AnswersAtOnceWithoutABaudRate) {
  TestLine test(0);
  const Bytes bytes = to_bytes(ping);
  test.line.push(ByteView(bytes).first(4), 1.0);
  EXPECT_TRUE(test.run(1.0).empty());
  EXPECT_TRUE(test.line.has_partial());
  test.line.push(ByteView(bytes).subspan(4), 1.0);
  EXPECT_EQ(test.run(1.0).size(), 14U);
  EXPECT_FALSE(test.line.has_partial());
  EXPECT_EQ(test.line.instructions(), 1U);
}

TEST(BusLine, EveryByteTakesTenBits) {
  TestLine test(1e6);
  test.line.push(to_bytes(ping), 2.0);
  const double answer = 2.0 + 100 * microsecond + return_delay;  // when its first bit leaves
  EXPECT_TRUE(test.run(2.0 + 99 * microsecond).empty());
  EXPECT_EQ(test.line.instructions(), 0U);
  EXPECT_TRUE(test.run(answer + 9 * microsecond).empty());
  EXPECT_EQ(test.line.instructions(), 1U);
  EXPECT_EQ(test.run(answer + 10 * microsecond).size(), 1U);
  EXPECT_EQ(test.run(answer + 139 * microsecond).size(), 12U);
  EXPECT_EQ(test.run(answer + 140 * microsecond).size(), 1U);
  EXPECT_TRUE(test.run(3.0).empty());
}

TEST(BusLine, DevicesAnswerOneAfterTheOther) {
  TestLine test(1e6);
  test.line.push(to_bytes(sync_read), 0);
  const double first = 160 * microsecond + return_delay + 150 * microsecond,
               second = first + return_delay + 150 * microsecond;
  EXPECT_EQ(test.run(first).size(), 15U);
  EXPECT_EQ(test.run(second - microsecond).size(), 14U);
  EXPECT_EQ(test.run(second).size(), 1U);
}

TEST(BusLine, InstructionsWaitForTheWire) {
  TestLine test(1e6);
  Bytes both = to_bytes(ping);
  append(both, to_bytes(ping));
  test.line.push(both, 0);
  const double end = 100 * microsecond + 2 * (return_delay + 140 * microsecond);
  EXPECT_EQ(test.run(end - 20 * microsecond).size(), 26U);
  EXPECT_EQ(test.run(end).size(), 2U);
}

TEST(BusLine, HangingUpDropsWhatIsOnItsWay) {
  TestLine test(1e6);
  test.line.push(to_bytes(ping), 0);
  (void)test.run(0.0007);
  test.line.hang_up();
  EXPECT_TRUE(test.run(1).empty());
  test.line.push(to_bytes(ping), 1);
  EXPECT_EQ(test.run(2).size(), 14U);
}

}  // namespace
}  // namespace murosimf::serial::dynamixel
