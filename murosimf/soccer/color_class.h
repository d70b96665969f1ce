/// color_class.h - classes of pixels by color: hue, saturation and brightness within bounds.
///
/// Source: hue, saturation, value of Smith, "Color gamut transform pairs", SIGGRAPH 1978.
#pragma once

#include <algorithm>
#include <cmath>

#include "murosimf/imaging/image.h"

namespace murosimf::soccer {

struct Hsv {
  double hue = 0;         ///< [deg] 0 to 360: 0 red, 120 green, 240 blue; 0 of grays
  double saturation = 0;  ///< [1] 0 gray, 1 pure
  double value = 0;       ///< [1] brightness of the brightest of the three
};

[[nodiscard]] inline Hsv hsv_of(const imaging::Rgb& pixel) noexcept {
  const int r = pixel.red, g = pixel.green, b = pixel.blue;
  const int most = std::max({r, g, b}), range = most - std::min({r, g, b});
  if (range == 0) return {0, 0, most / 255.0};
  double sixth = 0;
  if (most == r) {
    sixth = static_cast<double>(g - b) / range;
  } else if (most == g) {
    sixth = 2 + static_cast<double>(b - r) / range;
  } else {
    sixth = 4 + static_cast<double>(r - g) / range;
  }
  return {60 * (sixth < 0 ? sixth + 6 : sixth), static_cast<double>(range) / most, most / 255.0};
}

/// Hues within `hue_reach` of `hue`, around the circle; saturation and value within their bounds.
struct ColorClass {
  double hue = 0, hue_reach = 180;               ///< [deg]
  double least_saturation = 0, least_value = 0;  ///< [1]
  double most_saturation = 1, most_value = 1;    ///< [1]

  [[nodiscard]] bool contains(const imaging::Rgb& pixel) const noexcept {
    const Hsv c = hsv_of(pixel);
    return c.saturation >= least_saturation && c.saturation <= most_saturation && c.value >= least_value &&
           c.value <= most_value && std::abs(std::remainder(c.hue - hue, 360.0)) <= hue_reach;
  }
};

/// Carpets and grass in usual light.
inline constexpr ColorClass field_green{.hue = 130, .hue_reach = 45, .least_saturation = 0.35, .least_value = 0.12};

}  // namespace murosimf::soccer
