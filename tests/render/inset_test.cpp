// A picture in the corner of another one.
#include "murosimf/render/inset.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::render {
namespace {

using imaging::ColorImage;
using imaging::Rgb;

// Half of the light is the value 188 of sRGB (0.7354).
TEST(Inset, ASmallerPictureHasTheMeanOfLight) {
  ColorImage stripes(8, 4);
  for (int v = 0; v < 4; ++v) {
    for (int u = 0; u < 8; u += 2) stripes(u, v) = {255, 255, 255};
  }
  const ColorImage small = scaled(stripes, 4, 2);
  for (const Rgb& pixel : small.pixels()) EXPECT_EQ(pixel, (Rgb{188, 188, 188}));
  EXPECT_EQ(scaled(stripes, 16, 4)(1, 0), (Rgb{255, 255, 255})) << "a larger one repeats pixels";
}

TEST(Inset, StandsInItsFrameAtTheLowerRight) {
  ColorImage picture(400, 240, {10, 20, 30});
  try {
    draw_inset(picture, ColorImage(200, 100, {200, 0, 0}), "");
  } catch (const SetupError& error) {
    GTEST_SKIP() << error.what();
  }
  // 136 x 68 pixels within a border of 1, 5 from the edges
  EXPECT_EQ(picture(399 - 6, 239 - 6), (Rgb{200, 0, 0}));
  EXPECT_EQ(picture(399 - 5, 239 - 5), (Rgb{235, 235, 235}));
  EXPECT_EQ(picture(399 - 4, 239 - 4), (Rgb{10, 20, 30}));
  EXPECT_EQ(picture(400 - 6 - 136, 200), (Rgb{200, 0, 0}));
  EXPECT_EQ(picture(400 - 7 - 136, 200), (Rgb{235, 235, 235}));
  EXPECT_EQ(picture(390, 240 - 8 - 68), (Rgb{10, 20, 30}));
}

}  // namespace
}  // namespace murosimf::render
