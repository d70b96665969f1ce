#include "murosimf/serial/dynamixel/packet_checksum.h"

#include <array>
#include <numeric>

namespace murosimf::serial::dynamixel {
namespace {

constexpr std::uint16_t polynomial = 0x8005;  // x^16 + x^15 + x^2 + 1, without its highest bit

/// The remainders of all bytes: a checksum then takes one look-up for each byte.
constexpr std::array<std::uint16_t, 256> make_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < table.size(); ++byte) {
    unsigned rest = byte << 8;
    for (int bit = 0; bit < 8; ++bit) rest = (rest & 0x8000U) != 0 ? rest << 1 ^ polynomial : rest << 1;
    table[byte] = static_cast<std::uint16_t>(rest);
  }
  return table;
}

constexpr std::array<std::uint16_t, 256> crc_table = make_table();

}  // namespace

std::uint16_t crc16(ByteView bytes) {
  std::uint16_t crc = 0;
  for (const std::uint8_t byte : bytes) {
    crc = static_cast<std::uint16_t>(crc << 8 ^ crc_table[crc >> 8 ^ byte]);
  }
  return crc;
}

std::uint8_t checksum(ByteView bytes) {
  return static_cast<std::uint8_t>(~std::accumulate(bytes.begin(), bytes.end(), 0U));
}

}  // namespace murosimf::serial::dynamixel
