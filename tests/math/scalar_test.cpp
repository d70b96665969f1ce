#include "murosimf/math/scalar.h"

#include <limits>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

struct Worst {
  double sin = 0, cos = 0;
  void look_at(double angle) {
    const auto [s, c] = sin_cos(angle);
    sin = std::fmax(sin, static_cast<double>(std::fabs(s - std::sin(static_cast<long double>(angle)))));
    cos = std::fmax(cos, static_cast<double>(std::fabs(c - std::cos(static_cast<long double>(angle)))));
  }
};

// Law: sin_cos is the sine and the cosine. Tolerance: what the header promises for |angle| < 10; the reference is
// long double, whose own error (5e-20) does not count.
TEST(Scalar, SineAndCosineAreExactToTheLastBitsUpToTen) {
  Worst worst;
  for (int i = -200000; i <= 200000; ++i) worst.look_at(i * 5e-5);
  EXPECT_LT(worst.sin, 2e-16);
  EXPECT_LT(worst.cos, 2e-16);
}

// Law: the reduction by multiples of pi/2 keeps its accuracy where quadrants meet. Tolerance: as promised up to ten.
TEST(Scalar, SineAndCosineAreExactAtTheSeamsOfQuadrants) {
  Worst worst;
  for (int i = -12; i <= 12; ++i) {
    const double seam = i * pi / 4;
    for (const double angle : {std::nextafter(seam, -100.0), seam, std::nextafter(seam, 100.0)}) worst.look_at(angle);
    for (const double angle : {seam - 1e-9, seam + 1e-9}) worst.look_at(angle);
  }
  EXPECT_LT(worst.sin, 2e-16);
  EXPECT_LT(worst.cos, 2e-16);
}

// Law: the three-part reduction holds up to 1e5 rad. Tolerance: the first two products are exact there, so the error
// stays that of small angles (2e-16) plus the rounding of the third part (turns * 5e-15 * 2^-53, far below).
TEST(Scalar, LargeAnglesKeepTheirAccuracy) {
  Worst worst;
  for (int i = -99999; i <= 99999; ++i) worst.look_at(i * 1.00000123456789);
  EXPECT_LT(worst.sin, 2.5e-16);
  EXPECT_LT(worst.cos, 2.5e-16);
}

// Law: sine is odd and cosine is even, with no tolerance: left and right legs must mirror each other exactly.
TEST(Scalar, SymmetryIsExact) {
  for (int i = 0; i <= 100000; ++i) {
    const double angle = i * 1.7e-4;
    const auto [s, c] = sin_cos(angle);
    const auto [s_minus, c_minus] = sin_cos(-angle);
    ASSERT_EQ(s_minus, -s) << angle;
    ASSERT_EQ(c_minus, c) << angle;
  }
}

// Law: the values that standing robots live on are exact: sin 0 = 0, cos 0 = 1; tiny angles are their own sine.
TEST(Scalar, ZeroAndTinyAngles) {
  EXPECT_EQ(sin_cos(0.0).sin, 0.0);
  EXPECT_EQ(sin_cos(0.0).cos, 1.0);
  EXPECT_EQ(sin_cos(1e-9).sin, 1e-9);
  EXPECT_EQ(sin_cos(1e-300).sin, 1e-300);
  EXPECT_EQ(sin_cos(1e-300).cos, 1.0);
}

// Law: sin^2 + cos^2 = 1. Tolerance: both within 2e-16, so the sum of squares within 2 (|s| + |c|) 2e-16 < 6e-16
// plus its own rounding.
TEST(Scalar, SquaresAddUpToOne) {
  for (int i = 0; i < 10000; ++i) {
    const auto [s, c] = sin_cos(i * 0.00271828);
    ASSERT_NEAR(s * s + c * c, 1.0, 8e-16);
  }
}

// Rule: a bad number shows itself; it is not turned into a good one.
TEST(Scalar, NanStaysNan) {
  const auto [s, c] = sin_cos(std::nan(""));
  EXPECT_TRUE(std::isnan(s));
  EXPECT_TRUE(std::isnan(c));
}

// Rule: select takes values by mask, and never looks at the other one.
TEST(Scalar, OnlyZerosAreZero) {
  EXPECT_TRUE(are_zero(0.0, -0.0, 0.0));
  for (const double number : {std::numeric_limits<double>::denorm_min(), -1e-300, 1.0,
                              std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_FALSE(are_zero(number, 0.0, -0.0)) << number;
    EXPECT_FALSE(are_zero(0.0, -0.0, number)) << number;
  }
}

TEST(Scalar, SelectTakesOneSide) {
  EXPECT_EQ(select(true, 1.0, std::nan("")), 1.0);
  EXPECT_EQ(select(false, std::nan(""), 2.0), 2.0);
  EXPECT_TRUE(any(true));
  EXPECT_FALSE(all(false));
}

}  // namespace
}  // namespace murosimf
