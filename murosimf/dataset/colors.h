/// colors.h - random colors.
#pragma once

#include "murosimf/dataset/dice.h"
#include "murosimf/model/shape.h"

namespace murosimf::dataset {

/// `hue` [deg], saturation and value 0 to 1. Source: Smith, "Color gamut transform pairs", SIGGRAPH 1978.
[[nodiscard]] Color hsv(double hue, double saturation, double value);

/// Any hue.
[[nodiscard]] inline Color any_color(Dice& dice, const Range& saturation, const Range& value) {
  const double hue = dice.in({0, 360}), s = dice.in(saturation), v = dice.in(value);
  return hsv(hue, s, v);
}

}  // namespace murosimf::dataset
