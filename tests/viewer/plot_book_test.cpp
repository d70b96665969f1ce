#include "murosimf/viewer/plot_book.h"

#include <cmath>

#include <gtest/gtest.h>

namespace murosimf::viewer {
namespace {

TEST(Curve, ForgetsWhatIsLaterThanAJumpBack) {
  Curve curve;
  for (int i = 0; i < 10; ++i) curve.add(i, i);
  curve.add(4.5, -1);
  EXPECT_EQ(curve.times(), (std::vector<double>{0, 1, 2, 3, 4, 4.5}));
  EXPECT_EQ(curve.values().back(), -1);
  curve.add(4.5, -2);
  EXPECT_EQ(curve.times().size(), 6U) << "one value for one time";
}

TEST(Curve, IsThinnedOutWhereItIsOld) {
  Curve curve(100);
  for (int i = 0; i < 1000; ++i) curve.add(i, 2 * i);
  EXPECT_LE(curve.times().size(), 101U);
  EXPECT_EQ(curve.times().front(), 0);
  EXPECT_EQ(curve.times().back(), 999);
  for (std::size_t i = 0; i < curve.times().size(); ++i) EXPECT_EQ(curve.values()[i], 2 * curve.times()[i]);
}

TEST(Curve, RangeOfTheLastOnesWithoutNaN) {
  Curve curve;
  curve.add(0, 100);
  curve.add(1, -3);
  curve.add(2, NAN);
  curve.add(3, 5);
  EXPECT_EQ(curve.range(0.5).low, -3);
  EXPECT_EQ(curve.range(0.5).high, 5);
  EXPECT_EQ(Curve().range(0).high, 1);
}

TEST(Ticks, AreRoundNumbers) {
  EXPECT_EQ(ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  const auto small = ticks(-0.013, 0.021, 4);
  ASSERT_GE(small.size(), 3U);
  EXPECT_NEAR(small[0], -0.01, 1e-12);
  EXPECT_TRUE(ticks(1, 1, 4).empty());
  EXPECT_TRUE(ticks(NAN, 1, 4).empty());
}

}  // namespace
}  // namespace murosimf::viewer
