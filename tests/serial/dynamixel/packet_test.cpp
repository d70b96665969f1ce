// Packets of both protocols: those that the e-Manual prints, stuffing, damage, garbage.
#include "murosimf/serial/dynamixel/packet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "murosimf/serial/dynamixel/packet_checksum.h"
#include "murosimf/serial/dynamixel/packet_parser.h"

namespace murosimf::serial::dynamixel {
namespace {

std::vector<Packet> parsed(const Bytes& bytes, std::size_t at_once = 1 << 20) {
  PacketParser parser;
  std::vector<Packet> packets;
  for (std::size_t place = 0; place < bytes.size(); place += at_once) {
    parser.push(ByteView(bytes).subspan(place, std::min(at_once, bytes.size() - place)));
    while (auto packet = parser.next()) packets.push_back(std::move(*packet));
    EXPECT_LT(parser.pending(), most_bytes);
  }
  return packets;
}

struct Known {
  Packet packet;
  Bytes bytes;
};

/// ROBOTIS e-Manual, "Protocol 1.0" and "Protocol 2.0", the examples of the instructions.
const std::vector<Known>& known() {
  constexpr Protocol v1 = Protocol::v1, v2 = Protocol::v2;
  static const std::vector<Known> packets{
      {{v1, 1, 0x01, {}}, {0xFF, 0xFF, 0x01, 0x02, 0x01, 0xFB}},
      {status_packet(v1, 1, 0), {0xFF, 0xFF, 0x01, 0x02, 0x00, 0xFC}},
      {{v1, 1, 0x02, {0x2B, 0x01}}, {0xFF, 0xFF, 0x01, 0x04, 0x02, 0x2B, 0x01, 0xCC}},
      {status_packet(v1, 1, 0, Bytes{0x20}), {0xFF, 0xFF, 0x01, 0x03, 0x00, 0x20, 0xDB}},
      {status_packet(v1, 1, 0x24), {0xFF, 0xFF, 0x01, 0x02, 0x24, 0xD8}},
      {{v1, 1, 0x03, {0x0C, 0x64, 0xAA}}, {0xFF, 0xFF, 0x01, 0x05, 0x03, 0x0C, 0x64, 0xAA, 0xDC}},
      {{v1, 0xFE, 0x83, {0x1E, 0x04, 0x00, 0x10, 0x00, 0x50, 0x01, 0x01, 0x20, 0x02, 0x60, 0x03}},
       {0xFF, 0xFF, 0xFE, 0x0E, 0x83, 0x1E, 0x04, 0x00, 0x10, 0x00, 0x50, 0x01, 0x01, 0x20, 0x02, 0x60, 0x03, 0x67}},
      {{v1, 0xFE, 0x92, {0x00, 0x02, 0x01, 0x1E, 0x02, 0x02, 0x24}},
       {0xFF, 0xFF, 0xFE, 0x09, 0x92, 0x00, 0x02, 0x01, 0x1E, 0x02, 0x02, 0x24, 0x1D}},
      {{v2, 1, 0x01, {}}, {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x03, 0x00, 0x01, 0x19, 0x4E}},
      {status_packet(v2, 1, 0, Bytes{0x06, 0x04, 0x26}),
       {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x07, 0x00, 0x55, 0x00, 0x06, 0x04, 0x26, 0x65, 0x5D}},
      {{v2, 0xFE, 0x01, {}}, {0xFF, 0xFF, 0xFD, 0x00, 0xFE, 0x03, 0x00, 0x01, 0x31, 0x42}},
      {{v2, 1, 0x03, {0x74, 0x00, 0x00, 0x02, 0x00, 0x00}},
       {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x09, 0x00, 0x03, 0x74, 0x00, 0x00, 0x02, 0x00, 0x00, 0xCA, 0x89}},
      {{v2, 1, 0x08, {}}, {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x03, 0x00, 0x08, 0x2F, 0x4E}},
      {{v2, 1, 0x10, {0x01, 0x44, 0x58, 0x4C, 0x22}},
       {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x08, 0x00, 0x10, 0x01, 0x44, 0x58, 0x4C, 0x22, 0xB1, 0xDC}},
      {{v2, 0xFE, 0x82, {0x84, 0x00, 0x04, 0x00, 0x01, 0x02}},
       {0xFF, 0xFF, 0xFD, 0x00, 0xFE, 0x09, 0x00, 0x82, 0x84, 0x00, 0x04, 0x00, 0x01, 0x02, 0xCE, 0xFA}},
      {{v2, 0xFE, 0x92, {0x01, 0x90, 0x00, 0x02, 0x00, 0x02, 0x92, 0x00, 0x01, 0x00}},
       {0xFF, 0xFF, 0xFD, 0x00, 0xFE, 0x0D, 0x00, 0x92, 0x01, 0x90,
        0x00, 0x02, 0x00, 0x02, 0x92, 0x00, 0x01, 0x00, 0x1A, 0x05}},
  };
  return packets;
}

TEST(Packet, IsAsTheManualPrintsIt) {
  for (const Known& example : known()) {
    EXPECT_EQ(to_bytes(example.packet), example.bytes);
    EXPECT_EQ(parsed(example.bytes), std::vector{example.packet});
  }
}

TEST(Packet, ChecksumsAreTheStandardOnes) {
  const std::string digits = "123456789";  // the check value of CRC-16/UMTS, alias CRC-16/BUYPASS
  EXPECT_EQ(crc16(Bytes(digits.begin(), digits.end())), 0xFEE8);
  EXPECT_EQ(crc16({}), 0);
  EXPECT_EQ(checksum({}), 0xFF);
}

TEST(Packet, HasNoHeaderWithin) {
  const Packet packet{Protocol::v2, 7, 0x03, {0xFF, 0xFF, 0xFD, 0x00, 0xFF, 0xFF, 0xFD, 0xFD, 0xFF, 0xFF, 0xFF, 0xFD}};
  const Bytes bytes = to_bytes(packet);
  EXPECT_EQ(bytes.size(), 10 + packet.parameters.size() + 3);  // one FD for each of the three
  EXPECT_EQ(word(bytes, 5), packet.parameters.size() + 3 + 3);
  for (std::size_t i = 4; i + 3 < bytes.size(); ++i) {
    EXPECT_FALSE(bytes[i] == 0xFF && bytes[i + 1] == 0xFF && bytes[i + 2] == 0xFD && bytes[i + 3] != 0xFD) << i;
  }
  EXPECT_EQ(parsed(bytes), std::vector{packet});
}

TEST(PacketParser, TakesBothProtocolsFromOneLineInAnyPieces) {
  Bytes stream;
  std::vector<Packet> sent;
  for (const Known& example : known()) {
    append(stream, example.bytes);
    sent.push_back(example.packet);
  }
  for (const std::size_t at_once : {1U, 2U, 3U, 7U, 1000U}) EXPECT_EQ(parsed(stream, at_once), sent) << at_once;
}

TEST(PacketParser, SkipsWhatIsNoPacket) {
  const Packet ping{Protocol::v2, 3, 0x01, {}};
  for (const Bytes& garbage : std::vector<Bytes>{{0x00, 0x55, 0xFE},
                                                 {0xFF},
                                                 {0xFF, 0xFF},
                                                 {0xFF, 0xFF, 0xFF, 0xFF, 0xFF},
                                                 {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0xFF, 0xFF},  // longer than most_bytes
                                                 {0xFF, 0xFF, 0xFD, 0x00, 0x01, 0x00, 0x00},  // shorter than any
                                                 {0xFF, 0xFF, 0x01, 0x01, 0x01}}) {           // the same of 1.0
    Bytes stream = garbage;
    append(stream, to_bytes(ping));
    EXPECT_EQ(parsed(stream), std::vector{ping}) << testing::PrintToString(garbage);
  }
}

TEST(PacketParser, DropsDamagedPacketsAndTheirFalseLengthsSwallowNothing) {
  const Packet ping{Protocol::v1, 3, 0x01, {}};
  for (const Known& example : known()) {
    for (std::size_t damaged = 0; damaged < example.bytes.size(); ++damaged) {
      Bytes stream = example.bytes;
      stream[damaged] ^= 0x10;
      Bytes after = stream;
      for (int i = 0; i < 200; ++i) append(after, to_bytes(ping));  // more than any false length
      const std::vector<Packet> found = parsed(after);
      EXPECT_EQ(found.size(), 200U) << damaged;
      for (const Packet& packet : found) EXPECT_EQ(packet, ping);
    }
  }
}

TEST(PacketParser, ForgetsWhatHasBegun) {
  PacketParser parser;
  const Bytes half{0xFF, 0xFF, 0x01, 0xF0, 0x03};
  parser.push(half);
  EXPECT_FALSE(parser.next());
  EXPECT_EQ(parser.pending(), half.size());
  parser.forget();
  EXPECT_EQ(parser.pending(), 0U);
  parser.push(to_bytes({Protocol::v1, 1, 0x01, {}}));
  EXPECT_TRUE(parser.next());
}

/// Random packets, and bytes that begin none between them; the half of all bytes are those that mean something.
TEST(PacketParser, GivesBackWhatWasSent) {
  std::mt19937 random(1);
  const auto byte = [&] {
    constexpr std::uint8_t special[] = {0xFF, 0xFD, 0x00, 0x55};
    return random() % 2 == 0 ? special[random() % 4] : static_cast<std::uint8_t>(random());
  };
  Bytes stream;
  std::vector<Packet> sent;
  for (int i = 0; i < 5000; ++i) {
    Packet packet{random() % 2 == 0 ? Protocol::v1 : Protocol::v2,
                  static_cast<std::uint8_t>(random() % 0xFD),
                  byte(),
                  {}};
    packet.parameters.resize(random() % 60);
    for (std::uint8_t& parameter : packet.parameters) parameter = byte();
    append(stream, to_bytes(packet));
    sent.push_back(packet);
    for (std::size_t n = random() % 5; n > 0; --n) stream.push_back(static_cast<std::uint8_t>(random() % 0xF0));
  }
  EXPECT_EQ(parsed(stream, 97), sent);
}

}  // namespace
}  // namespace murosimf::serial::dynamixel
