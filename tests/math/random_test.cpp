#include "murosimf/math/random.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

using Four = std::array<std::uint32_t, 4>;

// Law: known answers of philox4x32-10 from the authors' distribution (Random123, kat_vectors).
TEST(Random, PhiloxKnownAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Four{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Four{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Four{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// Law: uniform in [0, 1): mean 1/2, variance 1/12, all 16 sixteenths equally full. Tolerance: 4.5 standard
// deviations of the estimate from 1e5 numbers; the numbers are fixed, so the test never flickers.
TEST(Random, UniformIsUniform) {
  const RandomStream stream(7, "uniform");
  const int count = 100000;
  double sum = 0, squares = 0;
  std::vector<int> cells(16);
  for (int i = 0; i < count; ++i) {
    const double u = stream.uniform(static_cast<std::uint64_t>(i));
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    squares += (u - 0.5) * (u - 0.5);
    ++cells[static_cast<std::size_t>(16 * u)];
  }
  EXPECT_NEAR(sum / count, 0.5, 4.5 * std::sqrt(1.0 / 12 / count));
  EXPECT_NEAR(squares / count, 1.0 / 12, 4.5 * std::sqrt(1.0 / 180 / count));
  for (const int cell : cells) EXPECT_NEAR(cell, count / 16.0, 4.5 * std::sqrt(count / 16.0));
}

// Rule: a range is stretched to [low, high).
TEST(Random, Range) {
  const RandomStream stream(7, "range");
  double least = 10, most = -10;
  for (std::uint64_t i = 0; i < 10000; ++i) {
    const double u = stream.uniform(i, -3, 5);
    ASSERT_EQ(u, -3 + 8 * stream.uniform(i));
    least = std::fmin(least, u);
    most = std::fmax(most, u);
  }
  EXPECT_GE(least, -3);
  EXPECT_LT(least, -2.99);
  EXPECT_LT(most, 5);
  EXPECT_GT(most, 4.99);
}

// Rule: a number is a pure function of seed, name and n: the same from another stream object and in another order.
TEST(Random, NumbersAreAddressed) {
  const RandomStream a(42, "blue1/start"), b(42, "blue1/start");
  const double late = a.uniform(1000);
  for (std::uint64_t i = 0; i < 1000; ++i) EXPECT_EQ(a.uniform(i), b.uniform(i));
  EXPECT_EQ(b.uniform(1000), late);
}

double correlation(const RandomStream& a, const RandomStream& b, std::uint64_t shift, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const auto n = static_cast<std::uint64_t>(i);
    sum += (a.uniform(n) - 0.5) * (b.uniform(n + shift) - 0.5);
  }
  return 12 * sum / count;
}

// Law: streams that differ in the name or in any part of the seed, and a stream against itself shifted, do not know
// of each other: correlation 0. Tolerance: 4.5 standard deviations (1 / sqrt(count)).
TEST(Random, StreamsAreIndependent) {
  const int count = 20000;
  const double limit = 4.5 / std::sqrt(count);
  const RandomStream stream(1, "blue1"), other_name(1, "blue2"), other_seed(2, "blue1");
  const RandomStream high_seed(1 + (std::uint64_t{1} << 32), "blue1");
  EXPECT_NEAR(correlation(stream, other_name, 0, count), 0, limit);
  EXPECT_NEAR(correlation(stream, other_seed, 0, count), 0, limit);
  EXPECT_NEAR(correlation(stream, high_seed, 0, count), 0, limit);
  EXPECT_NEAR(correlation(stream, stream, 1, count), 0, limit);
  EXPECT_NEAR(correlation(stream, stream, 0, count), 1, 0.05);  // the check does see correlation
}

// Rule: all 64 bits of the index count, so that a stream of nanoseconds does not repeat after 4 seconds.
TEST(Random, IndexHas64Bits) {
  const RandomStream stream(1, "index");
  EXPECT_NE(stream.uniform(5), stream.uniform(5 + (std::uint64_t{1} << 32)));
  EXPECT_NE(stream.uniform(5), stream.uniform(5 + (std::uint64_t{1} << 63)));
}

// Mean, deviation, and the shares within one and two deviations (0.6827, 0.9545) of many numbers.
TEST(RandomStream, NormalNumbersAreNormal) {
  const RandomStream stream(3, "normal");
  constexpr int count = 200000;
  double sum = 0, squares = 0, products = 0;
  int within_one = 0, within_two = 0;
  for (std::uint64_t n = 0; n < count; ++n) {
    const auto [x, y] = stream.normals(n);
    sum += x;
    products += x * y;
    squares += x * x;
    within_one += std::abs(x) < 1 ? 1 : 0;
    within_two += std::abs(x) < 2 ? 1 : 0;
  }
  EXPECT_NEAR(sum / count, 0, 0.01);
  EXPECT_NEAR(squares / count, 1, 0.015);
  EXPECT_NEAR(products / count, 0, 0.01);
  EXPECT_NEAR(within_one / static_cast<double>(count), 0.6827, 0.005);
  EXPECT_NEAR(within_two / static_cast<double>(count), 0.9545, 0.002);
}

}  // namespace
}  // namespace murosimf
