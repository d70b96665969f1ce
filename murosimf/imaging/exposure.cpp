#include "murosimf/imaging/exposure.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/imaging/srgb.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {

Exposure::Exposure(double gain) {
  if (!(gain > 0 && std::isfinite(gain))) {
    throw SetupError(fmt::format("an exposure gain of {}: it must be above 0", gain));
  }
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double light = std::min(1.0, gain * light_of_srgb(static_cast<double>(i) / 255));
    values_[i] = static_cast<std::uint8_t>(std::lround(255 * srgb_of_light(light)));
  }
}

void Exposure::apply(ColorImage& picture) const noexcept {
  for (Rgb& color : picture.pixels()) color = {values_[color.red], values_[color.green], values_[color.blue]};
}

LightMean::LightMean(int width, int height) : sums_(3 * static_cast<std::size_t>(width) * height) {
  MUROSIMF_ASSERT(width >= 0 && height >= 0);
  static_cast<void>(value_table());  // tables are computed here: step() must not wait for them
  static_cast<void>(light_table());
}

void LightMean::clear() noexcept {
  std::ranges::fill(sums_, 0U);
  count_ = 0;
}

void LightMean::add(const ColorImage& picture) noexcept {
  const auto& light = light_table();
  MUROSIMF_ASSERT(sums_.size() == 3 * picture.pixels().size());
  std::uint32_t* sum = sums_.data();
  for (const Rgb& color : picture.pixels()) {
    sum[0] += light[color.red];
    sum[1] += light[color.green];
    sum[2] += light[color.blue];
    sum += 3;
  }
  ++count_;
}

void LightMean::write(ColorImage& picture) const noexcept {
  const std::vector<std::uint8_t>& values = value_table();
  MUROSIMF_ASSERT(sums_.size() == 3 * picture.pixels().size());
  const double share = count_ > 0 ? 1.0 / count_ : 0;
  constexpr double half = 0.5;  // conversion to whole numbers truncates
  const auto value = [&](std::uint32_t sum) { return values[static_cast<std::size_t>(half + sum * share)]; };
  const std::uint32_t* sum = sums_.data();
  for (Rgb& color : picture.pixels()) {
    color = {value(sum[0]), value(sum[1]), value(sum[2])};
    sum += 3;
  }
}

}  // namespace murosimf::imaging
