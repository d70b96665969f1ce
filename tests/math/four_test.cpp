#include "murosimf/math/four.h"

#include <array>
#include <bit>
#include <cstdint>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

constexpr std::array<double, 4> a{0.1, -3.7e12, 5e-310, -0.0}, b{-7.3, 2.9e-3, 1.25, 0.0};

// A sum of products, whose bits a fused operation or another order would change.
TEST(Four, HasTheBitsOfDoubles) {
  const Four x(a[0], a[1], a[2], a[3]), y(b[0], b[1], b[2], b[3]);
  const Four sum = 0.3 * x + y * 1.1 - x;
  for (std::size_t i = 0; i < 4; ++i) {
    const double expected = 0.3 * a[i] + b[i] * 1.1 - a[i];
    EXPECT_EQ(std::bit_cast<std::uint64_t>(sum[i]), std::bit_cast<std::uint64_t>(expected)) << i;
  }
}

TEST(Four, BeginsWithZeros) {
  const Four none;
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(none[i], 0.0);
}

}  // namespace
}  // namespace murosimf
