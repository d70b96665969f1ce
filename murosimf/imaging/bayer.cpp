#include "murosimf/imaging/bayer.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {
namespace {

using Color = std::uint8_t Rgb::*;

/// The colors of a row's even and odd pixels.
struct RowColors {
  Color even, odd;
};

RowColors colors(BayerPattern pattern, bool odd_row) {
  const bool red_first = pattern == BayerPattern::rggb || pattern == BayerPattern::grbg;
  const bool green_first = pattern == BayerPattern::grbg || pattern == BayerPattern::gbrg;
  const Color other = red_first != odd_row ? &Rgb::red : &Rgb::blue;
  return green_first != odd_row ? RowColors{&Rgb::green, other} : RowColors{other, &Rgb::green};
}

}  // namespace

const std::vector<std::string_view>& bayer_patterns() {
  static const std::vector<std::string_view> names{"rggb", "bggr", "grbg", "gbrg"};
  return names;
}

BayerPattern bayer_pattern(std::string_view name) {
  const auto& names = bayer_patterns();
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw SetupError(unknown_name("Bayer pattern", name, names));
  return static_cast<BayerPattern>(found - names.begin());
}

void make_mosaic(const ColorImage& picture, BayerPattern pattern, GrayImage& mosaic) noexcept {
  MUROSIMF_ASSERT(mosaic.width() == picture.width() && mosaic.height() == picture.height());
  for (int v = 0; v < picture.height(); ++v) {
    // per row: the inner loop has no branches
    const auto [even, odd] = colors(pattern, v % 2 == 1);
    const auto from = picture.row(v);
    const auto to = mosaic.row(v);
    for (std::size_t u = 0; u < from.size(); ++u) to[u] = from[u].*(u % 2 == 0 ? even : odd);
  }
}

}  // namespace murosimf::imaging
