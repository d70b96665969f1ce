#include "murosimf/imaging/vignette.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/imaging/srgb.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {
namespace {

constexpr double whole = 65536;

/// [1/65536] Missing light by the place along one side; both sides together miss `share` in a corner.
std::vector<std::uint16_t> missing_along(int size, double share, double half_diagonal) {
  std::vector<std::uint16_t> all;
  for (int i = 0; i < size; ++i) {
    const double r = (i - 0.5 * (size - 1)) / half_diagonal;
    all.push_back(static_cast<std::uint16_t>(std::min(whole - 1, std::round(whole * share * r * r))));
  }
  return all;
}

}  // namespace

Vignette::Vignette(double share, int width, int height) : width_(width), height_(height) {
  if (!(share >= 0 && share <= 1)) throw SetupError(fmt::format("vignetting of {}: it must be 0 to 1", share));
  MUROSIMF_ASSERT(width > 0 && height > 0);
  const double half_diagonal = 0.5 * std::hypot(width, height);
  column_ = missing_along(width, share, half_diagonal);
  row_ = missing_along(height, share, half_diagonal);
  static_cast<void>(value_table());  // made here: apply() must not wait for them
  static_cast<void>(light_table());
}

void Vignette::apply(ColorImage& picture) const noexcept {
  MUROSIMF_ASSERT(picture.width() == width_ && picture.height() == height_);
  const auto& light = light_table();
  const std::vector<std::uint8_t>& values = value_table();
  for (int v = 0; v < height_; ++v) {
    const std::uint32_t row = row_[static_cast<std::size_t>(v)];
    const std::uint16_t* column = column_.data();
    for (Rgb& color : picture.row(v)) {
      const std::uint32_t missing = row + *column++;
      const std::uint32_t left = missing < 65536U ? 65536U - missing : 0U;
      const auto dimmed = [&](std::uint8_t value) { return values[(light[value] * left + 32768U) >> 16U]; };
      color = {dimmed(color.red), dimmed(color.green), dimmed(color.blue)};
    }
  }
}

}  // namespace murosimf::imaging
