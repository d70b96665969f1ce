#include "murosimf/dataset/colors.h"

#include <algorithm>
#include <cmath>

namespace murosimf::dataset {

Color hsv(double hue, double saturation, double value) {
  const auto part = [&](double shift) {
    const double k = std::fmod(shift + hue / 60, 6.0);
    return value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
  };
  return {part(5), part(3), part(1)};
}

}  // namespace murosimf::dataset
