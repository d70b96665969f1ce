#include "murosimf/imaging/depth_numbers.h"

#include <cmath>

#include <gtest/gtest.h>

namespace murosimf::imaging {
namespace {

std::uint16_t number_of(float depth) {
  DepthImage image(1, 1);
  image.pixels()[0] = depth;
  return millimeters(image).pixels()[0];
}

TEST(Millimeters, AreRoundedAndEndWhereSixteenBitsEnd) {
  EXPECT_EQ(number_of(1.2344F), 1234);
  EXPECT_EQ(number_of(1.2346F), 1235);
  EXPECT_EQ(number_of(65.535F), 65535);
  EXPECT_EQ(number_of(80.0F), 65535);
}

TEST(Millimeters, AreZeroWhereNothingIs) {
  for (const float nothing : {INFINITY, -INFINITY, NAN, 0.0F, -1.0F}) EXPECT_EQ(number_of(nothing), 0);
}

TEST(Millimeters, KeepTheSize) {
  const NumberImage numbers = millimeters(DepthImage(5, 3));
  EXPECT_EQ(numbers.width(), 5);
  EXPECT_EQ(numbers.height(), 3);
}

}  // namespace
}  // namespace murosimf::imaging
