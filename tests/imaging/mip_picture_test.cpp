#include "murosimf/imaging/mip_picture.h"

#include <gtest/gtest.h>

#include "murosimf/imaging/srgb.h"

namespace murosimf::imaging {
namespace {

TEST(MipPicture, HasHalfTheWidthAndHeightEachTime) {
  const MipPicture mip = mip_picture(ColorImage(11, 3, {10, 20, 200}));
  ASSERT_EQ(mip.levels.size(), 4U);
  const std::vector<std::pair<int, int>> sizes{{11, 3}, {5, 1}, {2, 1}, {1, 1}};
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    EXPECT_EQ(std::pair(mip.levels[i].width(), mip.levels[i].height()), sizes[i]);
    for (const Rgb& pixel : mip.levels[i].pixels()) EXPECT_EQ(pixel, (Rgb{10, 20, 200}));
  }
}

// Law: the mean of the light stays; of one white pixel of five, 2 / 5 of it in the first of two pixels, and none in the second.
TEST(MipPicture, KeepsTheMeanOfTheLight) {
  ColorImage row(5, 1);
  row(0, 0) = {255, 255, 255};
  const MipPicture mip = mip_picture(row);
  EXPECT_NEAR(mip.levels[1](0, 0).red, 255 * srgb_of_light(0.4), 0.6);
  EXPECT_EQ(mip.levels[1](1, 0).red, 0);
  EXPECT_NEAR(mip.levels[2](0, 0).red, 255 * srgb_of_light(0.2), 1.1);
}

}  // namespace
}  // namespace murosimf::imaging
