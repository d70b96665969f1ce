// Vignetting and white balance.
#include <gtest/gtest.h>

#include "murosimf/imaging/srgb.h"
#include "murosimf/imaging/vignette.h"
#include "murosimf/imaging/white_balance.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {
namespace {

double light_of(std::uint8_t value) { return light_of_srgb(value / 255.0); }

TEST(Vignette, TakesItsShareInTheCornersAndNothingInTheMiddle) {
  ColorImage picture(401, 301, {200, 100, 50});
  Vignette(0.4, 401, 301).apply(picture);
  EXPECT_EQ(picture(200, 150), (Rgb{200, 100, 50}));
  EXPECT_NEAR(light_of(picture(0, 0).red) / light_of(200), 0.6, 0.01);
  EXPECT_NEAR(light_of(picture(400, 300).green) / light_of(100), 0.6, 0.02);
  // half of the way to the corner: a quarter of that
  EXPECT_NEAR(light_of(picture(100, 75).red) / light_of(200), 0.9, 0.01);
}

TEST(Vignette, AWholeOneLeavesBlackCorners) {
  ColorImage picture(64, 64, {255, 255, 255});
  Vignette(1, 64, 64).apply(picture);
  EXPECT_LT(picture(0, 0).red, 60);
  EXPECT_THROW(Vignette(1.5, 64, 64), SetupError);
}

TEST(WhiteBalance, MultipliesLight) {
  ColorImage picture(2, 2, {100, 100, 200});
  WhiteBalance({1.5, 1, 4}).apply(picture);
  EXPECT_NEAR(light_of(picture(0, 0).red) / light_of(100), 1.5, 0.02);
  EXPECT_EQ(picture(0, 0).green, 100);
  EXPECT_EQ(picture(0, 0).blue, 255);
  EXPECT_THROW(WhiteBalance({1, 0, 1}), SetupError);
}

}  // namespace
}  // namespace murosimf::imaging
