#include "murosimf/recording/mcap/crc32.h"

#include <string>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

/// By the definition: one division of polynomials, bit by bit.
std::uint32_t bit_by_bit(std::string_view bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

TEST(Crc32, HasTheCheckValueOfTheStandard) { EXPECT_EQ(recording::crc32("123456789"), 0xcbf43926U); }

TEST(Crc32, IsThatOfTheDivisionForEveryLengthAndCut) {
  std::string bytes;
  for (int i = 0; i < 60; ++i) {
    EXPECT_EQ(recording::crc32(bytes), bit_by_bit(bytes)) << i;
    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
      const std::string_view all(bytes);
      EXPECT_EQ(recording::crc32(all.substr(cut), recording::crc32(all.substr(0, cut))), bit_by_bit(bytes));
    }
    bytes.push_back(static_cast<char>(i * i * 37 + 11));
  }
}

}  // namespace
}  // namespace murosimf
