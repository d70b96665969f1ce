/// image_png_test - pictures of cameras as files, and depths and labels in distinguishable colors.
#include "murosimf/render/image_png.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#ifdef MUROSIMF_HAS_CAIRO
#include "tests/render/picture.h"
#include "tests/temp_folder.h"
#endif

namespace murosimf::render {
namespace {

using imaging::Rgb;

#ifdef MUROSIMF_HAS_CAIRO
TEST(ImagePng, IsReadBackAsItWas) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {17, 5}, {64, 48}}) {
    imaging::ColorImage image(width, height);
    std::uint32_t noise = 12345;
    for (Rgb& pixel : image.pixels()) {
      for (std::uint8_t* channel : {&pixel.red, &pixel.green, &pixel.blue}) {
        noise = 1664525 * noise + 1013904223;
        *channel = static_cast<std::uint8_t>(noise >> 24);
      }
    }
    const std::string file = fixtures::temp_folder().string() + "/" + "image_png_test.png";
    std::ofstream(file, std::ios::binary) << image_png(image);
    const Picture picture(file);
    ASSERT_EQ(picture.columns(), width);
    ASSERT_EQ(picture.rows(), height);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const Color color = picture.pixel(u, v);
        const Rgb read{static_cast<std::uint8_t>(color.red), static_cast<std::uint8_t>(color.green),
                       static_cast<std::uint8_t>(color.blue)};
        EXPECT_EQ(read, image(u, v)) << u << ", " << v << " of " << width << "x" << height;
      }
    }
  }
}

TEST(ImagePng, HasItsTitleAtTheTopLeft) {
  const imaging::ColorImage image(400, 200, {10, 60, 20});
  const std::string file = fixtures::temp_folder().string() + "/" + "image_png_title_test.png";
  std::ofstream(file, std::ios::binary) << image_png(image, "a title");
  const Picture picture(file);
  int title = 0, elsewhere = 0;
  for (int v = 0; v < 200; ++v) {
    for (int u = 0; u < 400; ++u) {
      const bool is_changed = picture.pixel(u, v).red > 20;
      (u < 200 && v < 40 ? title : elsewhere) += is_changed ? 1 : 0;
    }
  }
  EXPECT_GT(title, 500);
  EXPECT_EQ(elsewhere, 0);
}
#endif

TEST(ShownDepths, AreGrayAndLinearInTheInverse) {
  imaging::DepthImage depth(5, 1);
  depth(0, 0) = 0.5F;
  depth(1, 0) = 1.0F;
  depth(2, 0) = 2.5F;
  depth(3, 0) = INFINITY;
  depth(4, 0) = -3.0F;  // beyond 90 degrees of a wide lens
  const imaging::ColorImage colors = shown(depth);
  const std::array<int, 5> expected{255, 128, 51, 0, 0};
  for (int u = 0; u < 5; ++u) {
    EXPECT_EQ(colors(u, 0).red, expected[u]) << u;
    EXPECT_EQ(colors(u, 0).green, expected[u]) << u;
    EXPECT_EQ(colors(u, 0).blue, expected[u]) << u;
  }
}

TEST(ShownDepths, OfNothingAreBlack) {
  for (const float z : {INFINITY, -1.0F, 0.0F, NAN}) {
    const imaging::ColorImage colors = shown(imaging::DepthImage(3, 2, z));
    for (const Rgb& pixel : colors.pixels()) EXPECT_EQ(pixel, Rgb{}) << z;
  }
  EXPECT_TRUE(shown(imaging::DepthImage()).empty());
}

TEST(ShownLabels, OfTwoTeamsOfElevenCanBeToldApart) {
  constexpr int labels = 4 + 1 + 22;
  imaging::LabelImage image(labels, 1);
  for (int i = 0; i < labels; ++i) image(i, 0) = static_cast<std::uint16_t>(i);
  const imaging::ColorImage colors = shown(image);
  double nearest = INFINITY;
  for (int i = 0; i < labels; ++i) {
    for (int k = 0; k < i; ++k) {
      const Rgb a = colors(i, 0), b = colors(k, 0);
      nearest = std::min(nearest, std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue));
    }
  }
  EXPECT_GT(nearest, 20);
}

TEST(ShownLabels, AreTheSameInAllPictures) {
  imaging::LabelImage alone(1, 1, 9), among(4, 1, 2);
  among(3, 0) = 9;
  EXPECT_EQ(shown(alone)(0, 0), shown(among)(3, 0));
  EXPECT_EQ(shown(imaging::LabelImage(1, 1, 0))(0, 0), Rgb{}) << "the background is black";
  EXPECT_NO_THROW((void)shown(imaging::LabelImage(1, 1, 65535)));
}

TEST(ShownMosaics, AreGray) {
  imaging::GrayImage mosaic(2, 1);
  mosaic(1, 0) = 200;
  EXPECT_EQ(shown(mosaic)(0, 0), Rgb{});
  EXPECT_EQ(shown(mosaic)(1, 0), (Rgb{200, 200, 200}));
}

}  // namespace
}  // namespace murosimf::render
