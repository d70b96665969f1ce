// Colors by name, and regions of them, against a flood fill.
#include "murosimf/soccer/color_blobs.h"

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf::soccer {
namespace {

using imaging::ColorImage;
using imaging::Rgb;

constexpr Rgb magenta{217, 25, 153}, green{40, 120, 56};
constexpr ColorClass pink{.hue = 320, .hue_reach = 25, .least_saturation = 0.5, .least_value = 0.2};

TEST(ColorClass, KnowsHuesOfPureColors) {
  EXPECT_EQ(hsv_of({255, 0, 0}).hue, 0);
  EXPECT_EQ(hsv_of({0, 255, 0}).hue, 120);
  EXPECT_EQ(hsv_of({0, 0, 255}).hue, 240);
  EXPECT_EQ(hsv_of({255, 0, 255}).hue, 300);
  EXPECT_EQ(hsv_of({0, 0, 0}).value, 0);
  EXPECT_EQ(hsv_of({90, 90, 90}).saturation, 0);
  EXPECT_DOUBLE_EQ(hsv_of({200, 100, 100}).saturation, 0.5);
}

TEST(ColorClass, GoesAroundTheCircleOfHues) {
  const ColorClass red{.hue = 5, .hue_reach = 20, .least_saturation = 0.3};
  EXPECT_TRUE(red.contains({255, 0, 40}));  // 351 deg
  EXPECT_TRUE(red.contains({255, 90, 0}));  // 21 deg
  EXPECT_FALSE(red.contains({255, 120, 0}));
  EXPECT_FALSE(red.contains({255, 0, 120}));
  EXPECT_FALSE(red.contains({255, 200, 200}));
}

TEST(BlobFinder, MeasuresABox) {
  ColorImage picture(40, 30, green);
  for (int v = 5; v <= 14; ++v) {
    for (int u = 7; u <= 12; ++u) picture(u, v) = magenta;
  }
  BlobFinder finder(pink);
  const auto& blobs = finder.find(picture);
  ASSERT_EQ(blobs.size(), 1u);
  EXPECT_EQ(blobs[0].pixels, 60);
  EXPECT_DOUBLE_EQ(blobs[0].center.u, 9.5);
  EXPECT_DOUBLE_EQ(blobs[0].center.v, 9.5);
  EXPECT_DOUBLE_EQ(blobs[0].lowest.u, 9.5);
  EXPECT_DOUBLE_EQ(blobs[0].lowest.v, 14);
  EXPECT_EQ(blobs[0].left, 7);
  EXPECT_EQ(blobs[0].right, 12);
  EXPECT_EQ(blobs[0].top, 5);
  EXPECT_EQ(blobs[0].bottom, 14);
}

TEST(BlobFinder, JoinsWhatMeetsFartherDown) {
  ColorImage picture(40, 30, green);  // a U, with arms that are apart for 19 rows
  for (int v = 0; v < 20; ++v) picture(3, v) = picture(30, v) = magenta;
  for (int u = 3; u <= 30; ++u) picture(u, 19) = magenta;
  BlobFinder finder(pink);
  ASSERT_EQ(finder.find(picture).size(), 1u);
  EXPECT_EQ(finder.find(picture)[0].pixels, 2 * 20 + 26);
}

TEST(BlobFinder, LeavesOutWhatIsSmall) {
  ColorImage picture(40, 30, green);
  picture(3, 3) = picture(4, 3) = picture(5, 4) = magenta;
  picture(20, 20) = magenta;
  EXPECT_EQ(BlobFinder(pink, 2).find(picture).size(), 1u);
  EXPECT_TRUE(BlobFinder(pink, 4).find(picture).empty());
  EXPECT_TRUE(BlobFinder(pink).find(ColorImage{}).empty());
}

/// Sizes of all regions, by flood fill over the eight neighbors.
std::vector<int> flood(ColorImage picture) {
  std::vector<int> sizes;
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      if (!(picture(u, v) == magenta)) continue;
      int size = 0;
      std::vector<std::pair<int, int>> open{{u, v}};
      picture(u, v) = green;
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        ++size;
        for (int j = std::max(0, y - 1); j <= std::min(picture.height() - 1, y + 1); ++j) {
          for (int i = std::max(0, x - 1); i <= std::min(picture.width() - 1, x + 1); ++i) {
            if (!(picture(i, j) == magenta)) continue;
            picture(i, j) = green;
            open.emplace_back(i, j);
          }
        }
      }
      sizes.push_back(size);
    }
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

TEST(BlobFinder, FindsWhatAFloodFillFinds) {
  fixtures::Dice dice("blobs");
  BlobFinder finder(pink, 1);
  for (int round = 0; round < 200; ++round) {
    ColorImage picture(31, 23, green);
    const double share = dice.uniform(0.1, 0.7);
    for (Rgb& pixel : picture.pixels()) pixel = dice.chance(share) ? magenta : green;
    std::vector<int> sizes;
    for (const Blob& blob : finder.find(picture)) sizes.push_back(blob.pixels);
    EXPECT_EQ(sizes, flood(picture)) << "picture " << round;
  }
}

}  // namespace
}  // namespace murosimf::soccer
