#include "murosimf/math/exponential.h"

#include <gtest/gtest.h>

#include "murosimf/math/pack.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::Dice;
using fixtures::same_bits;

/// |found/right - 1|
double relative(double found, long double right) {
  return static_cast<double>(std::fabs((static_cast<long double>(found) - right) / right));
}

// Law: exponential is e^x. Tolerance: what the header promises; the reference is long double.
TEST(Exponential, IsExactToTheLastBitsUpToSevenHundred) {
  double worst = 0;
  for (int i = -700000; i <= 700000; ++i) {
    const double x = i * 1e-3;
    worst = std::fmax(worst, relative(exponential(x), std::exp(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 5e-16);
}

// Law: e^0 = 1 and tiny arguments give 1, exactly: a joint at rest has its whole Stribeck part.
TEST(Exponential, OfNothingIsOne) {
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-0.0), 1.0);
  EXPECT_EQ(exponential(-1e-300), 1.0);
}

// Law: logarithm is the natural logarithm, for numbers of every size. Tolerance: what the header promises.
TEST(Exponential, LogarithmIsExactToTheLastBits) {
  Dice dice("logarithm");
  double worst = 0;
  for (int i = 0; i < 500000; ++i) {
    const double x = std::exp2(dice.uniform(-1000, 1000));
    worst = std::fmax(worst, relative(logarithm(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 1e-15);
}

// Law: the logarithm keeps its digits where it goes through zero, and where halves of the range meet.
TEST(Exponential, LogarithmKeepsItsDigitsNearOne) {
  EXPECT_EQ(logarithm(1.0), 0.0);
  double worst = 0;
  for (int i = -400000; i <= 400000; ++i) {
    const double x = 1 + i * 1.2345e-6;
    if (i != 0) worst = std::fmax(worst, relative(logarithm(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 1e-15);
}

// Rule: a lane has the bits of the scalar. No tolerance.
TEST(Exponential, LanesAreScalars) {
  Dice dice("exponential lanes");
  for (int i = 0; i < 20000; ++i) {
    Pack8 x, positive;
    for (int lane = 0; lane < Pack8::lanes; ++lane) {
      x.set_lane(lane, dice.uniform(-700, 700));
      positive.set_lane(lane, std::exp2(dice.uniform(-1000, 1000)));
    }
    const Pack8 e = exponential(x), log = logarithm(positive);
    for (int lane = 0; lane < Pack8::lanes; ++lane) {
      ASSERT_TRUE(same_bits(e.lane(lane), exponential(x.lane(lane)))) << x.lane(lane);
      ASSERT_TRUE(same_bits(log.lane(lane), logarithm(positive.lane(lane)))) << positive.lane(lane);
    }
  }
}

}  // namespace
}  // namespace murosimf
