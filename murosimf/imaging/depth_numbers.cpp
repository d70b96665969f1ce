#include "murosimf/imaging/depth_numbers.h"

#include <algorithm>
#include <cmath>

namespace murosimf::imaging {

NumberImage millimeters(const DepthImage& depth) {
  NumberImage numbers(depth.width(), depth.height());
  std::ranges::transform(depth.pixels(), numbers.pixels().begin(), [](float z) {
    if (!std::isfinite(z) || z <= 0) return std::uint16_t{0};
    return static_cast<std::uint16_t>(std::lround(std::min(1000.0 * z, 65535.0)));
  });
  return numbers;
}

}  // namespace murosimf::imaging
