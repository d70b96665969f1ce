#include "murosimf/math/pack.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::Dice;
using fixtures::same_bits;

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Pack8 random_pack(Dice& dice, double low, double high) {
  Pack8 p;
  for (int i = 0; i < Pack8::lanes; ++i) p.set_lane(i, dice.uniform(low, high));
  return p;
}
Pack8 pack(const std::array<double, 8>& numbers) {
  Pack8 p;
  for (int i = 0; i < Pack8::lanes; ++i) p.set_lane(i, numbers[static_cast<std::size_t>(i)]);
  return p;
}

/// Every lane of f(a, b) has the bits of f(lane of a, lane of b).
template <class F>
void expect_like_double(const Pack8& a, const Pack8& b, const F& f) {
  const Pack8 result = f(a, b);
  for (int i = 0; i < Pack8::lanes; ++i) {
    const double expected = f(a.lane(i), b.lane(i));
    EXPECT_TRUE(same_bits(result.lane(i), expected)) << "lane " << i << ": " << result.lane(i) << " and " << expected;
  }
}

template <class F>
void expect_like_double(const F& f) {
  Dice dice("pack");
  for (int i = 0; i < 200; ++i) expect_like_double(random_pack(dice, -5, 5), random_pack(dice, -5, 5), f);
  const Pack8 hard = pack({0.0, -0.0, 1e308, -1e308, 5e-324, infinity, nan_value, -infinity});
  const Pack8 turned = pack({-0.0, 3.0, 1e308, nan_value, -5e-324, infinity, 1.0, 0.0});
  expect_like_double(hard, turned, f);
  expect_like_double(turned, hard, f);
}

// Rule: numbers go into lanes and come out of the same lanes; one number fills all.
TEST(Pack, LanesKeepTheirPlaces) {
  Pack8 p = 2.5;
  for (int i = 0; i < 8; ++i) EXPECT_EQ(p.lane(i), 2.5);
  for (int i = 0; i < 8; ++i) p.set_lane(i, i * 1.25);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(p.lane(i), i * 1.25);
  const Pack8 fresh{};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(fresh.lane(i), 0);
}

// Law: a constant of a model has the same bits in every lane as alone, the sign of zero included. Axes and rotations of
// models are full of -0.
TEST(Pack, BroadcastKeepsTheSignOfZero) {
  for (const double number : {-0.0, 0.0, -2.5, 5e-324, infinity, nan_value}) {
    const Pack8 p = number;
    for (int i = 0; i < 8; ++i) EXPECT_TRUE(same_bits(p.lane(i), number)) << number;
  }
}

// Law: every lane is a double, bit for bit, NaN, infinities, signed zeros and denormals included. No tolerance.
TEST(Pack, ArithmeticIsThatOfDoubles) {
  expect_like_double([](const auto& a, const auto& b) { return a + b; });
  expect_like_double([](const auto& a, const auto& b) { return a - b; });
  expect_like_double([](const auto& a, const auto& b) { return a * b; });
  expect_like_double([](const auto& a, const auto& b) { return a / b; });
  expect_like_double([](const auto& a, const auto&) { return -a; });
  expect_like_double([](const auto& a, const auto& b) { return 0.1 * a + b * 0.3 - 7.0; });
}

// Law: the same for roots and magnitudes; abs clears the sign of -0 and of NaN's lane only.
TEST(Pack, RootAndMagnitudeAreThoseOfDoubles) {
  expect_like_double([](const auto& a, const auto&) { return abs(a); });
  expect_like_double([](const auto& a, const auto& b) { return sqrt(a * a + b * b); });
  expect_like_double([](const auto& a, const auto&) { return sqrt(a); });  // NaN for negative lanes
}

// Law: comparisons and select per lane; every comparison with NaN is false.
TEST(Pack, SelectIsThatOfDoubles) {
  expect_like_double([](const auto& a, const auto& b) { return select(a < b, a, b); });
  expect_like_double([](const auto& a, const auto& b) { return select(a > b, a, b); });
  expect_like_double([](const auto& a, const auto& b) { return select(a == b, a, decltype(a * b)(1.0)); });
  expect_like_double([](const auto& a, const auto& b) {
    using S = std::decay_t<decltype(a)>;
    return select((a < b) | (a > S(3.0)), a, b);
  });
  expect_like_double([](const auto& a, const auto& b) {
    using S = std::decay_t<decltype(a)>;
    return select((a < b) & (b > S(0.0)), a, b);
  });
}

// Rule: any is true if one single lane is, whichever it is.
TEST(Pack, AnySeesEveryLane) {
  EXPECT_FALSE(any(Pack8(0.0) > Pack8(0.0)));
  EXPECT_TRUE(any(Pack8(0.0) == Pack8(0.0)));
  for (int i = 0; i < 8; ++i) {
    Pack8 p = 0.0;
    p.set_lane(i, 1.0);
    EXPECT_TRUE(any(p > Pack8(0.5))) << i;
    EXPECT_FALSE(any(p > Pack8(1.5))) << i;
  }
}

// Law: sine and cosine are the same polynomials in every lane. No tolerance.
TEST(Pack, SineAndCosineAreThoseOfDoubles) {
  const auto sine = [](const auto& a, const auto&) { return sin_cos(a).sin; };
  const auto cosine = [](const auto& a, const auto&) { return sin_cos(a).cos; };
  Dice dice("pack sine");
  for (int i = 0; i < 2000; ++i) {
    const double reach = i % 2 == 0 ? 4 : 1000;
    const Pack8 angles = random_pack(dice, -reach, reach);
    expect_like_double(angles, angles, sine);
    expect_like_double(angles, angles, cosine);
  }
  for (int i = 0; i < 8; ++i) {
    Pack8 angles = random_pack(dice, -4, 4);
    angles.set_lane(i, nan_value);
    expect_like_double(angles, angles, sine);
    expect_like_double(angles, angles, cosine);
  }
}

// Rule: a robot whose numbers went bad does not touch its neighbors, in any lane.
TEST(Pack, NanStaysInItsLane) {
  Dice dice("pack nan");
  for (int bad = 0; bad < 8; ++bad) {
    Pack8 p = random_pack(dice, 1, 2);
    p.set_lane(bad, nan_value);
    const Pack8 result = sqrt(abs(select(p < Pack8(1.5), p * p, 1.0 / p) - p)) + sin_cos(p).sin;
    for (int i = 0; i < 8; ++i) EXPECT_EQ(std::isnan(result.lane(i)), i == bad) << bad << ' ' << i;
  }
}

}  // namespace
}  // namespace murosimf
