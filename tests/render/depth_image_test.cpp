// Near hides far at every sample, in whatever order things are drawn.
#include "murosimf/render/depth_image.h"

#include <gtest/gtest.h>

#ifdef MUROSIMF_HAS_CAIRO

namespace murosimf::render {
namespace {

constexpr Color red{1, 0, 0}, blue{0, 0, 1};
constexpr std::uint32_t solid_red = 0xffff0000, solid_blue = 0xff0000ff;

/// A rectangle whose depth grows from left to right.
std::vector<Vec3d> rectangle(double left, double right, double top, double bottom, double z_left, double z_right) {
  return {{left, top, z_left}, {right, top, z_right}, {right, bottom, z_right}, {left, bottom, z_left}};
}

std::uint32_t pixel(const DepthImage& image, int columns, int x, int y) { return image.pixels()[y * columns + x]; }

TEST(DepthImage, NothingIsTransparent) {
  const DepthImage image(4, 3);
  EXPECT_EQ(image.pixels(), std::vector<std::uint32_t>(12, 0));
}

TEST(DepthImage, CoversPixelsAndPartsOfPixels) {
  DepthImage image(10, 10);
  image.fill(rectangle(2, 6.5, 3, 5, 0, 0), red, 1);
  EXPECT_EQ(pixel(image, 10, 2, 3), solid_red);
  EXPECT_EQ(pixel(image, 10, 5, 4), solid_red);
  EXPECT_EQ(pixel(image, 10, 1, 3), 0u);
  EXPECT_EQ(pixel(image, 10, 2, 5), 0u);
  EXPECT_EQ(pixel(image, 10, 6, 4), 0x7f7f0000u) << "half covered, times coverage";
}

TEST(DepthImage, NearHidesFarInAnyOrder) {
  for (const bool red_first : {false, true}) {
    DepthImage image(10, 10);
    for (const bool is_red : {red_first, !red_first}) {
      // they go through each other in the middle
      if (is_red) {
        image.fill(rectangle(0, 10, 0, 10, 1, -1), red, 1);
      } else {
        image.fill(rectangle(0, 10, 0, 10, -1, 1), blue, 2);
      }
    }
    for (int y = 0; y < 10; ++y) {
      EXPECT_EQ(pixel(image, 10, 4, y), solid_red);
      EXPECT_EQ(pixel(image, 10, 5, y), solid_blue);
    }
  }
}

TEST(DepthImage, LeavesOutWhatIsSeenFromItsEdgeOrOutside) {
  DepthImage image(10, 10);
  image.fill(std::vector<Vec3d>{{1, 1, 0}, {9, 9, 0}, {9, 9, 5}, {1, 1, 5}}, red, 1);
  image.fill(rectangle(-50, -20, 2, 8, 0, 0), red, 1);
  EXPECT_EQ(image.pixels(), std::vector<std::uint32_t>(100, 0));
  image.fill(rectangle(-1e6, 1e6, -1e6, 1e6, 0, 0), blue, 2);
  EXPECT_EQ(image.pixels(), std::vector<std::uint32_t>(100, solid_blue));
}

TEST(DepthImage, DrawsALineWhereOnePartEnds) {
  DepthImage image(10, 10);
  image.fill(rectangle(0, 5, 0, 10, 0, 0), red, 1);
  image.fill(rectangle(5, 10, 0, 10, 0, 0), red, 2);
  image.draw_edges();
  EXPECT_EQ(pixel(image, 10, 2, 5), solid_red);
  EXPECT_EQ(pixel(image, 10, 7, 5), solid_red);
  const std::uint32_t edge = pixel(image, 10, 4, 5) >> 16 & 0xff;
  EXPECT_LT(edge, 220u);
  EXPECT_GT(edge, 100u);
}

}  // namespace
}  // namespace murosimf::render

#endif
