/// protocol.h - numbers of the two Dynamixel protocols (ROBOTIS e-Manual, "Protocol 1.0" and "Protocol 2.0").
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace murosimf::serial::dynamixel {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

enum class Protocol : std::uint8_t { v1 = 1, v2 = 2 };

inline constexpr std::uint8_t broadcast_id = 0xFE;
inline constexpr std::uint8_t status_instruction = 0x55;  ///< of every answer of protocol 2.0

enum class Instruction : std::uint8_t {
  ping = 0x01,
  read = 0x02,
  write = 0x03,
  reg_write = 0x04,  ///< written at the next action
  action = 0x05,
  factory_reset = 0x06,
  reboot = 0x08,          ///< 2.0 only
  clear = 0x10,           ///< 2.0 only
  sync_read = 0x82,       ///< 2.0, and servos of Feetech
  sync_write = 0x83,      ///< never answered, as bulk_write
  fast_sync_read = 0x8A,  ///< 2.0 only: all answer in one packet, as to fast_bulk_read
  bulk_read = 0x92,
  bulk_write = 0x93,      ///< 2.0 only
  fast_bulk_read = 0x9A,  ///< 2.0 only
};

/// Bits of the error byte of protocol 1.0.
namespace error_v1 {
inline constexpr std::uint8_t voltage = 0x01, angle_limit = 0x02, overheating = 0x04, range = 0x08, checksum = 0x10,
                              overload = 0x20, instruction = 0x40;
}

/// Numbers in the error byte of protocol 2.0; its highest bit reports a hardware error.
namespace error_v2 {
inline constexpr std::uint8_t result_fail = 1, instruction = 2, checksum = 3, data_range = 4, data_length = 5,
                              data_limit = 6, access = 7, alert = 0x80;
}

/// Two bytes, the lower one first, as both protocols have them.
[[nodiscard]] constexpr std::uint16_t word(ByteView bytes, std::size_t place) {
  return static_cast<std::uint16_t>(bytes[place] | bytes[place + 1] << 8);
}
inline void append(Bytes& bytes, ByteView more) {
  bytes.reserve(bytes.size() + more.size());
  for (const std::uint8_t byte : more) bytes.push_back(byte);
}
inline void append_word(Bytes& bytes, std::size_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>(value >> 8 & 0xFF));
}

}  // namespace murosimf::serial::dynamixel
