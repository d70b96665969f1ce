// Depths and labels as colors.
#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/render/image_png.h"

namespace murosimf::render {
namespace {

using imaging::Rgb;

template <class Pixel, class Map>
imaging::ColorImage mapped(const imaging::Image<Pixel>& image, const Map& map) {
  imaging::ColorImage colors(image.width(), image.height());
  MUROSIMF_ASSERT(image.pixels().size() == colors.pixels().size());
  std::ranges::transform(image.pixels(), colors.pixels().begin(), map);
  return colors;
}

/// Colors that differ much between successive labels: hues by the golden angle.
Rgb color_of(std::uint16_t label) {
  constexpr std::array<Rgb, 4> fixed{Rgb{0, 0, 0}, {60, 130, 70}, {255, 255, 255}, {250, 220, 60}};
  if (label < fixed.size()) return fixed[label];
  // The golden ratio spreads hues of any number of labels evenly.
  const double hue = 6 * std::fmod(0.07 + 0.381966 * (label - 4), 1.0);
  const auto channel = [&](double from) {
    const double k = std::fmod(from + hue, 6.0);
    return static_cast<std::uint8_t>(std::lround(255 * (1 - std::clamp(std::min(k, 4 - k), 0.0, 1.0))));
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace

imaging::ColorImage shown(const imaging::DepthImage& depth) {
  float nearest = INFINITY;
  for (const float z : depth.pixels()) {
    if (z > 0) nearest = std::min(nearest, z);
  }
  // In 1 / z steps of depth nearby are as visible as larger ones far away.
  return mapped(depth, [&](float z) {
    const double share = std::isfinite(z) && z > 0 ? nearest / z : 0;
    const auto gray = static_cast<std::uint8_t>(std::lround(255 * share));
    return Rgb{gray, gray, gray};
  });
}

imaging::ColorImage shown(const imaging::LabelImage& labels) { return mapped(labels, color_of); }

imaging::ColorImage shown(const imaging::GrayImage& mosaic) {
  return mapped(mosaic, [](std::uint8_t value) { return Rgb{value, value, value}; });
}

}  // namespace murosimf::render
