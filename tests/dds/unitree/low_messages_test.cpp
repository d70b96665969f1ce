// Messages of Unitree's humanoids: checksums of an implementation of their own in Python (bit by bit, packed by struct), sizes, places of members,
// and damaged ones.
#include "murosimf/dds/unitree/low_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "murosimf/dds/unitree/checksum.h"
#include "murosimf/dds/unitree/motion_switcher.h"
#include "murosimf/dds/unitree/motor_order.h"
#include "murosimf/model/error.h"

namespace murosimf::dds::unitree {
namespace {

// The check value of CRC-32/MPEG-2 in catalogues, 0x0376E6E7, is that of bytes; of words the highest byte is the last.
TEST(UnitreeChecksum, IsThatOfTheVendor) {
  EXPECT_EQ(checksum({}), 0xFFFFFFFFU);
  EXPECT_EQ(checksum(std::array<std::uint8_t, 4>{}), 0xC704DD7BU);
  std::array<std::uint8_t, 11> bytes{};
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
  EXPECT_EQ(checksum(std::span(bytes).first(8)), 0xA3141BDAU);
  EXPECT_EQ(checksum(bytes), 0xA3141BDAU) << "three bytes are no word";
}

LowCommand some_command() {
  LowCommand command{.mode_machine = 5, .reserve = {1, 2, 3, 4}};
  for (std::size_t i = 0; i < most_motors; ++i) {
    command.motors[i] = {.mode = 1,
                         .q = static_cast<float>(0.01 * static_cast<double>(i)),
                         .dq = -0.5F,
                         .tau = 0.25F,
                         .kp = 60,
                         .kd = 1.5F};
  }
  return command;
}

TEST(UnitreeMessages, KnowTheChecksumOfCommands) {
  EXPECT_EQ(checksum_of(some_command()), 0xF08EF992U);  // pack('<2B2x' + 'B3x5fI' * 35 + '5I', ...)
  EXPECT_EQ(checksum_of(LowCommand{}), 0xFE172F9FU);
}

TEST(UnitreeMessages, ReadTheCommandsThatPeersWrite) {
  LowCommand sent = some_command();
  sent.motors[34].reserve = 7;
  sent.crc = checksum_of(sent);
  CdrWriter message;
  write_low_command(message, sent);
  EXPECT_EQ(message.bytes().size(), encapsulation_size + command_size - 4) << "CDR has no gap before the first motor";
  const std::optional<LowCommand> read = read_low_command(message.bytes());
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->mode_machine, 5);
  EXPECT_EQ(read->motors[10].q, 0.1F);
  EXPECT_EQ(read->motors[10].kd, 1.5F);
  EXPECT_EQ(read->motors[34].reserve, 7U);
  EXPECT_EQ(read->reserve[3], 4U);
  EXPECT_EQ(read->crc, checksum_of(*read));
  Bytes padded = message.bytes();
  padded[encapsulation_size + 3] = 0xAA;  // between mode and q of the first motor: peers leave there what they like
  EXPECT_EQ(checksum_of(*read_low_command(padded)), read->crc);
  for (std::size_t size = 0; size < message.bytes().size(); ++size)
    EXPECT_FALSE(read_low_command(std::span(message.bytes()).first(size))) << size;
}

TEST(UnitreeMessages, EveryBitOfACommandCounts) {
  LowCommand command = some_command();
  command.crc = checksum_of(command);
  CdrWriter message;
  write_low_command(message, command);
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    Bytes bytes = message.bytes();
    const std::size_t at = encapsulation_size + random() % (bytes.size() - encapsulation_size);
    bytes[at] ^= static_cast<std::uint8_t>(1U << random() % 8);
    const std::optional<LowCommand> read = read_low_command(bytes);
    ASSERT_TRUE(read.has_value());
    CdrWriter again;
    write_low_command(again, *read);
    const bool in_gap = again.bytes() == message.bytes();
    EXPECT_EQ(read->crc == checksum_of(*read), in_gap) << at;
  }
}

TEST(UnitreeMessages, WriteLowStates) {
  LowState state{.mode_machine = kind_of_robot, .tick = 1234, .imu = {{}, {1, 2, 3}, {0, 0, 9.81F}}, .count = 29};
  for (std::size_t i = 0; i < state.count; ++i) {
    state.motors[i] = {
        .q = static_cast<float>(0.01 * static_cast<double>(i)), .dq = 1, .ddq = 2, .tau = 3, .temperature = 25};
  }
  CdrWriter message;
  write_low_state(message, state);
  EXPECT_EQ(message.bytes().size(), encapsulation_size + state_size - 4);
  const auto word_at = [&](std::size_t place) {
    std::uint32_t word = 0;
    std::memcpy(&word, &message.bytes()[encapsulation_size + place], sizeof word);
    return word;
  };
  // pack('<2I2B2xI' + '13fh2x' + 'B3x4f2hf7I' * 35 + '40B5I', ...)
  EXPECT_EQ(word_at(state_size - 8), 0xD939A81FU) << "its checksum, the last word";
  EXPECT_EQ(word_at(12), 1234U) << "tick";
  EXPECT_EQ(message.bytes()[encapsulation_size + 9], kind_of_robot);
}

TEST(UnitreeMessages, TurnRollPitchAndYawIntoAQuaternion) {
  CdrWriter message;
  write_imu(message, {.rpy = {0.1F, -0.2F, 0.3F}});
  CdrReader from(message.bytes());
  // the product of the quaternions of three turns, about z, y and x, in NumPy; w first
  for (const float expected : {0.98185617F, 0.06407135F, -0.09115755F, 0.1534393F})
    EXPECT_NEAR(from.number<float>(), expected, 1e-6);
}

TEST(UnitreeMessages, RefuseNumbersThatAreNone) {
  LowCommand command = some_command();
  EXPECT_TRUE(is_finite(command));
  command.motors[34].kd = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(is_finite(command));
  command.motors[34] = {.q = std::nanf("")};
  EXPECT_FALSE(is_finite(command));
}

TEST(UnitreeJoints, AreFoundByName) {
  std::vector<std::string> names;
  for (const std::string_view name : motor_order()) names.emplace(names.begin(), std::string(name) + "_joint");
  const std::vector<std::size_t> places = place_joints(names);
  ASSERT_EQ(places.size(), 29U);
  EXPECT_EQ(places.front(), 28U);
  EXPECT_EQ(places.back(), 0U);
  names.back() = "tail";
  EXPECT_THROW((void)place_joints(names), SetupError);
}

Bytes request(std::int64_t id, std::int64_t call) {
  CdrWriter message;
  message.number(id).number(call).number<std::int64_t>(0).number<std::int32_t>(0).number<std::uint8_t>(0);
  return message.text("{}").blob("").bytes();
}

TEST(UnitreeMotionSwitcher, ReleasesTheMotors) {
  bool stands = true;
  const auto ask = [&](std::int64_t call) { return switch_motion(*read_request(request(77, call)), stands); };
  EXPECT_EQ(ask(1001).data, R"({"form":"0","name":"ai"})");
  const Answer released = ask(1003);
  EXPECT_EQ(released.id, 77);
  EXPECT_EQ(released.call, 1003);
  EXPECT_EQ(released.code, 0);
  EXPECT_FALSE(stands);
  EXPECT_EQ(ask(1001).data, R"({"form":"0","name":""})");
  EXPECT_EQ(ask(1002).code, 0);
  EXPECT_TRUE(stands);
  EXPECT_EQ(ask(1099).code, 3203);
  const Bytes whole = request(1, 1001);
  for (std::size_t size = 0; size + 5 < whole.size(); ++size)
    EXPECT_FALSE(read_request(std::span(whole).first(size))) << size;
}

}  // namespace
}  // namespace murosimf::dds::unitree
