#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "murosimf/imaging/bayer.h"
#include "murosimf/imaging/exposure.h"
#include "murosimf/imaging/gaussian_blur.h"
#include "murosimf/imaging/image_noise.h"
#include "murosimf/imaging/srgb.h"
#include "murosimf/model/error.h"
#include "tests/law.h"

namespace murosimf::imaging {
namespace {

/// Random colors, with plain areas and hard edges between them.
ColorImage busy_picture(int width, int height) {
  const RandomStream random(3, "picture");
  ColorImage picture(width, height);
  std::uint64_t n = 0;
  for (Rgb& color : picture.pixels()) {
    const auto byte = [&] { return static_cast<std::uint8_t>(random.uniform(n++, 0, 256)); };
    color = {byte(), byte(), static_cast<std::uint8_t>(n % 64 < 32 ? 0 : 255)};
  }
  return picture;
}

/// The sum by definition, in both directions at once.
double blurred_red(const ColorImage& picture, int u, int v, double sigma) {
  const int radius = static_cast<int>(std::ceil(6 * sigma));
  double sum = 0, weights = 0;
  for (int y = -radius; y <= radius; ++y) {
    for (int x = -radius; x <= radius; ++x) {
      const double weight = std::exp(-0.5 * (x * x + y * y) / (sigma * sigma));
      sum +=
          weight * picture(std::clamp(u + x, 0, picture.width() - 1), std::clamp(v + y, 0, picture.height() - 1)).red;
      weights += weight;
    }
  }
  return sum / weights;
}

TEST(GaussianBlur, IsTheWeightedMeanOfAllNeighbors) {
  for (const double sigma : {0.4, 1.0, 3.7}) {
    const ColorImage sharp = busy_picture(41, 33);
    ColorImage picture = sharp;
    GaussianBlur(sigma, 41, 33).apply(picture);
    law::Worst worst;
    for (int v = 0; v < 33; ++v) {
      for (int u = 0; u < 41; ++u) worst.see(std::fabs(picture(u, v).red - blurred_red(sharp, u, v, sigma)), u, v);
    }
    law::expect_below({.law = "Gaussian blur of a picture",
                       .level = fmt::format("sigma {} px", sigma),
                       .source = "sum over all neighbors by definition"},
                      worst, 0.75, "of 255");
  }
}

TEST(GaussianBlur, LeavesPlainAreasAsTheyAre) {
  for (const double sigma : {0.1, 0.3, 2.0, 20.0}) {
    for (const std::uint8_t level : {0, 1, 100, 254, 255}) {
      ColorImage picture(30, 20, {level, level, level});
      GaussianBlur(sigma, 30, 20).apply(picture);
      for (const Rgb& color : picture.pixels()) ASSERT_EQ(color, (Rgb{level, level, level})) << sigma;
    }
  }
  EXPECT_THROW(GaussianBlur(0, 4, 4), SetupError);
  EXPECT_THROW(GaussianBlur(std::nan(""), 4, 4), SetupError);
}

TEST(Srgb, GoesToLightAndBack) {
  EXPECT_NEAR(light_of_srgb(0.5), 0.21404114, 1e-8);
  EXPECT_NEAR(srgb_of_light(0.18), 0.46135613, 1e-8);
  for (int i = 0; i < 256; ++i) {
    EXPECT_NEAR(srgb_of_light(light_of_srgb(i / 255.0)), i / 255.0, 1e-7);
    EXPECT_EQ(value_table()[light_table()[static_cast<std::size_t>(i)]], i);
  }
}

TEST(Exposure, MultipliesLight) {
  ColorImage picture(3, 1, {100, 0, 200});
  Exposure(2).apply(picture);
  const auto doubled = [](int value) { return std::lround(255 * srgb_of_light(2 * light_of_srgb(value / 255.0))); };
  EXPECT_EQ(picture(2, 0), (Rgb{static_cast<std::uint8_t>(doubled(100)), 0, 255}));
  ColorImage same = busy_picture(20, 20);
  Exposure(1).apply(same);
  EXPECT_EQ(same(7, 3), busy_picture(20, 20)(7, 3));
  EXPECT_THROW(Exposure{0}, SetupError);
  EXPECT_THROW(Exposure{INFINITY}, SetupError);
}

TEST(LightMean, AddsLightNotValues) {
  LightMean mean(2, 1);
  mean.add(ColorImage(2, 1, {255, 0, 10}));
  mean.add(ColorImage(2, 1, {0, 0, 10}));
  ColorImage picture(2, 1);
  mean.write(picture);
  EXPECT_EQ(picture(1, 0), (Rgb{188, 0, 10})) << "half the light of white";
  mean.clear();
  mean.write(picture);
  EXPECT_EQ(picture(0, 0), Rgb{});
  const ColorImage one = busy_picture(2, 1);
  mean.add(one);
  mean.write(picture);
  EXPECT_EQ(picture(1, 0), one(1, 0));
}

struct Moments {
  double mean, deviation;
};

/// Of the light of one color of all pixels.
Moments light_moments(const ColorImage& picture, std::uint8_t Rgb::*color) {
  double sum = 0, squares = 0;
  for (const Rgb& pixel : picture.pixels()) {
    const double light = light_of_srgb(pixel.*color / 255.0);
    sum += light;
    squares += light * light;
  }
  const auto n = static_cast<double>(picture.pixels().size());
  return {sum / n, std::sqrt(squares / n - sum * sum / (n * n))};
}

TEST(ImageNoise, GrowsWithTheRootOfLight) {
  const ImageNoiseSpec spec{.shot = 0.06, .read = 0.02};
  const ImageNoise noise(spec, RandomStream(1, "blue1/camera"));
  for (const std::uint8_t level : {100, 160, 220}) {
    ColorImage picture(400, 300, {level, level, level});
    noise.apply(picture, 5);
    const double light = light_of_srgb(level / 255.0);
    const double expected = std::sqrt(spec.shot * spec.shot * light + spec.read * spec.read);
    for (const auto color : {&Rgb::red, &Rgb::green, &Rgb::blue}) {
      const auto [mean, deviation] = light_moments(picture, color);
      EXPECT_NEAR(mean, light, 0.001);
      law::expect_near({.law = "noise of an image sensor: standard deviation over the expected one",
                        .level = fmt::format("value {} of 255", level),
                        .source = "sqrt(shot^2 light + read^2)"},
                       deviation / expected, 1, 0.02, "1");
    }
  }
}

TEST(ImageNoise, IsIndependentOfNeighborsColorsAndPictures) {
  const ImageNoise noise({.shot = 0, .read = 0.05}, RandomStream(1, "blue1/camera"));
  const auto made = [&](std::uint64_t number) {
    ColorImage picture(300, 200, {188, 188, 188});
    noise.apply(picture, number);
    return picture;
  };
  const ColorImage a = made(0), b = made(1);
  double neighbors = 0, colors = 0, pictures = 0, variance = 0;
  for (int v = 0; v < 200; ++v) {
    for (int u = 0; u + 1 < 300; ++u) {
      const double red = a(u, v).red - 188.0;
      variance += red * red;
      neighbors += red * (a(u + 1, v).red - 188.0);
      colors += red * (a(u, v).green - 188.0);
      pictures += red * (b(u, v).red - 188.0);
    }
  }
  for (const double correlation : {neighbors, colors, pictures}) EXPECT_LT(std::fabs(correlation / variance), 0.02);
  EXPECT_GT(variance, 1e5);
}

TEST(ImageNoise, IsAFunctionOfStreamAndNumber) {
  const auto made = [](std::uint64_t seed, std::uint64_t number) {
    ColorImage picture(50, 40, {120, 120, 120});
    ImageNoise({.shot = 0.1, .read = 0}, RandomStream(seed, "red2/camera")).apply(picture, number);
    return std::vector<Rgb>(picture.pixels().begin(), picture.pixels().end());
  };
  EXPECT_EQ(made(1, 7), made(1, 7));
  EXPECT_NE(made(1, 7), made(1, 8));
  EXPECT_NE(made(1, 7), made(2, 7));
  ColorImage untouched = busy_picture(20, 20);
  ImageNoise({}, RandomStream(1, "")).apply(untouched, 0);
  EXPECT_EQ(untouched(11, 13), busy_picture(20, 20)(11, 13));
  EXPECT_THROW(ImageNoise({.shot = -1}, RandomStream(1, "")), SetupError);
  EXPECT_THROW(ImageNoise({.read = std::nan("")}, RandomStream(1, "")), SetupError);
}

TEST(Bayer, TakesTheColorThatThePatternNames) {
  const ColorImage picture = busy_picture(7, 5);
  for (const std::string_view name : bayer_patterns()) {
    GrayImage mosaic(7, 5);
    make_mosaic(picture, bayer_pattern(name), mosaic);
    for (int v = 0; v < 5; ++v) {
      for (int u = 0; u < 7; ++u) {
        const char filter = name[static_cast<std::size_t>(2 * (v % 2) + u % 2)];
        const Rgb& color = picture(u, v);
        ASSERT_EQ(mosaic(u, v), filter == 'r' ? color.red : filter == 'g' ? color.green : color.blue) << name;
      }
    }
  }
  EXPECT_THROW(static_cast<void>(bayer_pattern("rgbg")), SetupError);
}

}  // namespace
}  // namespace murosimf::imaging
