#include "murosimf/math/hash.h"

#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

template <class... Values>
std::uint64_t hash_of(const Values&... values) {
  Hasher hasher;
  (hasher.add(values), ...);
  return hasher.value();
}

// Law: the mixing step is splitmix64: its first number for seed 0 (Steele, Lea, Flood; reference code by S. Vigna).
TEST(Hash, KnownAnswer) { EXPECT_EQ(hash_of(std::uint64_t{0}), 0xE220A8397B1DCDAFu); }

// Rule: order counts, and so does how often the same is added.
TEST(Hash, OrderAndCountMatter) {
  EXPECT_NE(hash_of(1.0, 2.0), hash_of(2.0, 1.0));
  EXPECT_NE(hash_of(1.0), hash_of(1.0, 1.0));
  EXPECT_NE(hash_of(0.0), hash_of(0.0, 0.0));
  EXPECT_EQ(hash_of(1.0, 2.0), hash_of(1.0, 2.0));
}

// Rule: whatever is no number is the same, and nothing else is.
TEST(Hash, WhatIsNoNumberIsOne) {
  const double usual = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hash_of(-usual), hash_of(usual));
  EXPECT_EQ(hash_of(std::bit_cast<double>(std::uint64_t{0xfff8000000001234})), hash_of(usual));
  EXPECT_NE(hash_of(std::numeric_limits<double>::infinity()), hash_of(usual));
  EXPECT_NE(hash_of(-0.0), hash_of(0.0));
}

// Law: one changed bit changes about half of the 64 bits (avalanche). Tolerance: the mean over 64 flips of a fair
// 64-bit word has a standard deviation of 4 / 8 = 0.5; a single one of 4.
TEST(Hash, OneBitChangesHalfOfTheBits) {
  const std::uint64_t word = std::bit_cast<std::uint64_t>(3.14159);
  int sum = 0;
  for (int bit = 0; bit < 64; ++bit) {
    const int changed = std::popcount(hash_of(word) ^ hash_of(word ^ (std::uint64_t{1} << bit)));
    EXPECT_GT(changed, 10) << bit;
    sum += changed;
  }
  EXPECT_NEAR(sum / 64.0, 32, 3);
}

// Rule: numbers count by their bits: -0 is not 0, and the last bit of a number shows.
TEST(Hash, NumbersCountByTheirBits) {
  EXPECT_NE(hash_of(0.0), hash_of(-0.0));
  EXPECT_NE(hash_of(1.0), hash_of(std::nextafter(1.0, 2.0)));
}

// Rule: texts do not run into each other.
TEST(Hash, TextsHaveEnds) {
  using namespace std::string_view_literals;
  EXPECT_NE(hash_of("ab"sv, "c"sv), hash_of("a"sv, "bc"sv));
  EXPECT_NE(hash_of(""sv), hash_of());
  EXPECT_NE(hash_of("\xff"sv), hash_of("\x7f"sv));
}

// Rule: different states give different hashes: none of 1e5 neighbors meet (chance 3e-10 for a fair hash).
TEST(Hash, NoCollisionsAmongNeighbors) {
  std::set<std::uint64_t> seen;
  for (std::uint64_t i = 0; i < 100000; ++i) seen.insert(hash_of(i, std::uint64_t{7}));
  EXPECT_EQ(seen.size(), 100000u);
}

}  // namespace
}  // namespace murosimf
