#include "murosimf/imaging/white_balance.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/imaging/srgb.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {

WhiteBalance::WhiteBalance(const Vec3d& gains) {
  const std::array<double, 3> factors{gains.x, gains.y, gains.z};
  for (std::size_t color = 0; color < factors.size(); ++color) {
    if (!(factors[color] > 0 && std::isfinite(factors[color]))) {
      throw SetupError(fmt::format("a white balance of [{}, {}, {}]: all must be above 0", gains.x, gains.y, gains.z));
    }
    for (std::size_t value = 0; value < values_[color].size(); ++value) {
      const double light = std::min(1.0, factors[color] * light_of_srgb(static_cast<double>(value) / 255));
      values_[color][value] = static_cast<std::uint8_t>(std::lround(255 * srgb_of_light(light)));
    }
  }
}

void WhiteBalance::apply(ColorImage& picture) const noexcept {
  for (Rgb& color : picture.pixels()) {
    color = {values_[0][color.red], values_[1][color.green], values_[2][color.blue]};
  }
}

}  // namespace murosimf::imaging
