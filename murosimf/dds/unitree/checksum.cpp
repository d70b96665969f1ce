#include "murosimf/dds/unitree/checksum.h"

#include <array>
#include <cstddef>

namespace murosimf::dds::unitree {
namespace {

/// What eight bits at the upper end of the remainder add to it when they leave.
constexpr std::array<std::uint32_t, 256> remainders() {
  constexpr std::uint32_t polynomial = 0x04C11DB7, highest = 0x80000000;
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t rest = byte << 24;
    for (int bit = 0; bit < 8; ++bit) rest = (rest << 1) ^ ((rest & highest) != 0 ? polynomial : 0);
    table[byte] = rest;
  }
  return table;
}

}  // namespace

std::uint32_t checksum(std::span<const std::uint8_t> words) noexcept {
  static constexpr std::array<std::uint32_t, 256> table = remainders();
  constexpr std::size_t word = 4;
  std::uint32_t rest = 0xFFFFFFFF;
  for (std::size_t end = word; end <= words.size(); end += word) {
    for (std::size_t i = 1; i <= word; ++i) rest = (rest << 8) ^ table[(rest >> 24) ^ words[end - i]];
  }
  return rest;
}

}  // namespace murosimf::dds::unitree
