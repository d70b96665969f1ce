// Reads that all answer in one packet, and which devices hear at which rate.
#include <gtest/gtest.h>

#include "murosimf/serial/dynamixel/bus_line.h"
#include "murosimf/serial/dynamixel/imu_board.h"
#include "murosimf/serial/dynamixel/packet_checksum.h"
#include "murosimf/serial/dynamixel/servo_device.h"

namespace murosimf::serial::dynamixel {
namespace {

struct ReadBus {
  explicit ReadBus(const std::string& table, int servos = 3) {
    for (int id = 1; id <= servos; ++id) add(table, id);
  }
  void add(const std::string& table, int id) {
    bus.add(std::make_unique<ServoDevice>(*find_servo_table(table), static_cast<std::uint8_t>(id), ServoOptions{}));
  }
  Bytes send(Instruction instruction, const Bytes& parameters, Protocol protocol = Protocol::v2, double rate = 0) {
    Bytes all;
    const Packet packet{protocol, broadcast_id, static_cast<std::uint8_t>(instruction), parameters};
    for (const BusAnswer& answer : bus.execute(packet, rate)) append(all, answer.bytes);
    return all;
  }
  Bus bus;
};

TEST(FastRead, IsOnePacketOfAll) {
  ReadBus test("xm430_w350");
  const Bytes answer = test.send(Instruction::fast_sync_read, {132, 0, 4, 0, 3, 1});
  ASSERT_EQ(answer.size(), 8 + 2 * (4 + 4));  // the last checksum is that of the packet
  EXPECT_EQ(Bytes(answer.begin(), answer.begin() + 8), (Bytes{0xFF, 0xFF, 0xFD, 0, 0xFE, 17, 0, 0x55}));
  EXPECT_EQ(Bytes(answer.begin() + 8, answer.begin() + 14), (Bytes{0, 3, 0, 8, 0, 0}));
  EXPECT_EQ(Bytes(answer.begin() + 16, answer.begin() + 22), (Bytes{0, 1, 0, 8, 0, 0}));
  EXPECT_EQ(word(answer, 14), crc16(ByteView(answer).first(14)));
  EXPECT_EQ(word(answer, 22), crc16(ByteView(answer).first(22)));

  const Bytes bulk = test.send(Instruction::fast_bulk_read, {2, 132, 0, 4, 0, 1, 0, 0, 2, 0});
  ASSERT_EQ(bulk.size(), 8U + 8 + 6);
  EXPECT_EQ(bulk[5], 1 + 8 + 6);
  EXPECT_EQ(Bytes(bulk.begin() + 16, bulk.begin() + 20), (Bytes{0, 1, 0xFC, 0x03}));
}

TEST(FastRead, EndsWhereOneIsMissing) {
  ReadBus test("xm430_w350");
  const Bytes answer = test.send(Instruction::fast_sync_read, {132, 0, 4, 0, 1, 9, 2});
  EXPECT_EQ(answer.size(), 8U + 8);
  EXPECT_EQ(answer[5], 1 + 3 * 8) << "its length is that of all";
  EXPECT_TRUE(test.send(Instruction::fast_sync_read, {132, 0, 4, 0, 9, 1}).empty());
  const Bytes refused = test.send(Instruction::fast_sync_read, {0x78, 5, 2, 0, 1, 2});
  ASSERT_EQ(refused.size(), 8U + 2 * 6);
  EXPECT_EQ(refused[8], error_v2::access);
  EXPECT_TRUE(test.send(Instruction::fast_sync_read, {132, 0, 4}).empty());
  EXPECT_TRUE(ReadBus("mx28").send(Instruction::fast_sync_read, {36, 2, 1}, Protocol::v1).empty());
}

TEST(SyncRead, OfProtocol1IsFeetechsOnly) {
  ReadBus feetech("sts3215"), dynamixel("mx28");
  const Bytes answer = feetech.send(Instruction::sync_read, {56, 2, 1, 3}, Protocol::v1);
  ASSERT_EQ(answer.size(), 2U * 8);
  EXPECT_EQ(Bytes(answer.begin(), answer.begin() + 7), (Bytes{0xFF, 0xFF, 1, 4, 0, 0, 8}));
  EXPECT_EQ(answer[10], 3);
  EXPECT_TRUE(dynamixel.send(Instruction::sync_read, {36, 2, 1, 3}, Protocol::v1).empty());
  EXPECT_EQ(dynamixel.send(Instruction::bulk_read, {0, 2, 1, 36}, Protocol::v1).size(), 8U);
}

TEST(BaudRate, ServosHearAtTheirOwnOnly) {
  ReadBus test("xm430_w350", 2);
  EXPECT_TRUE(test.bus.devices()[0]->listen_at(2e6));
  EXPECT_TRUE(test.bus.devices()[1]->listen_at(57600));
  EXPECT_FALSE(test.bus.devices()[1]->listen_at(250e3));
  const auto found = [&](double rate) { return test.send(Instruction::ping, {}, Protocol::v2, rate).size() / 14; };
  for (const double rate : {9600.0, 57600.0, 115200.0, 1e6, 2e6, 3e6, 4e6, 4.5e6}) {
    EXPECT_EQ(found(rate), rate == 2e6 || rate == 57600 ? 1U : 0U) << rate;
  }
  EXPECT_EQ(found(0), 2U);
  EXPECT_EQ(found(58000), 1U) << "UARTs differ a little";
  const Packet change{Protocol::v2, 2, static_cast<std::uint8_t>(Instruction::write), {8, 0, 3}};
  EXPECT_EQ(test.bus.execute(change, 57600).size(), 1U);
  EXPECT_EQ(found(57600), 0U);
  EXPECT_EQ(found(1e6), 1U);
}

TEST(BaudRate, IsThatOfTheManual) {
  const ControlTable& mx = *find_servo_table("mx28");
  EXPECT_NEAR(mx.baud_rate(1), 1e6, 1);
  EXPECT_NEAR(mx.baud_rate(34), 57142.9, 0.1);
  EXPECT_EQ(mx.baud_rate(250), 2.25e6);
  EXPECT_EQ(mx.baud_rate(253), 0);
  EXPECT_EQ(mx.baud_value(57600), 34);
  EXPECT_EQ(find_servo_table("ax12")->baud_rate(250), 0);
  EXPECT_EQ(find_servo_table("sts3215")->baud_rate(7), 38400);
  EXPECT_EQ(find_servo_table("xl330_m288")->baud_rate(6), 4e6);
}

TEST(BaudRate, SaysHowLongBytesTake) {
  ReadBus test("xm430_w350", 1);
  BusLine line(test.bus, 1e6);
  const Bytes ping = to_bytes({Protocol::v2, 1, 0x01, {}});
  for (const double rate : {1e6, 57600.0}) {
    EXPECT_TRUE(test.bus.devices()[0]->listen_at(rate));
    line.set_rate(rate);
    line.push(ping, 0);
    Bytes answer;
    const double all = (10 + 14) * 10 / rate + 0.0005;  // both ways, and the return delay time
    line.run(all - 1e-6, answer);
    EXPECT_EQ(answer.size(), 13U) << rate;
    line.run(all + 1e-6, answer);
    EXPECT_EQ(answer.size(), 14U) << rate;
    line.hang_up();
  }
  line.set_rate(1e6);
  line.push(ping, 1);
  Bytes none;
  line.run(2, none);
  EXPECT_TRUE(none.empty()) << "it listens at 57600";
}

TEST(ImuBoard, AnswersPingsToEverybodyIfItIsTold) {
  for (const bool broadcast : {false, true}) {
    ReadBus test("mx28_2", 2);
    test.bus.add(std::make_unique<ImuBoard>(Protocol::v2, 200, broadcast));
    EXPECT_EQ(test.send(Instruction::ping, {}).size() / 14, broadcast ? 3U : 2U);
    EXPECT_EQ(test.bus.execute({Protocol::v2, 200, 0x01, {}}).size(), 1U);
  }
}

}  // namespace
}  // namespace murosimf::serial::dynamixel
