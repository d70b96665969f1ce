#include "murosimf/imaging/gaussian_blur.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {
namespace {

// Levels are kept in 1/128, so that two of them fit into 16 bits.
constexpr int fraction_bits = 7;

int checked_radius(double sigma) {
  if (sigma > 0 && sigma <= 20) return static_cast<int>(std::ceil(4 * sigma));
  throw SetupError(fmt::format("a blur of {} pixels: it must be above 0 and at most 20", sigma));
}

/// Of the center and its neighbors to one side. Their sum, neighbors twice, is 65536, or one less if the center is all.
std::vector<std::uint16_t> gaussian(double sigma, int radius) {
  std::vector<double> exact;
  MUROSIMF_ASSERT(sigma > 0 && radius >= 0);
  double sum = 0;
  for (int i = 0; i <= radius; ++i) {
    exact.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += (i == 0 ? 1 : 2) * exact.back();
  }
  std::vector<std::uint16_t> weights;
  long rest = 65536;  // the center takes the rounding of the others: a uniform picture stays as it is
  for (int i = 1; i <= radius; ++i) {
    weights.push_back(static_cast<std::uint16_t>(std::lround(65536 * exact[static_cast<std::size_t>(i)] / sum)));
    rest -= 2L * weights.back();
  }
  weights.insert(weights.begin(), static_cast<std::uint16_t>(std::min(rest, 65535L)));
  return weights;
}

}  // namespace

GaussianBlur::GaussianBlur(double sigma, int width, int height)
    : radius_(checked_radius(sigma)), width_(width), height_(height), weights_(gaussian(sigma, radius_)) {
  MUROSIMF_ASSERT(width >= 0 && height >= 0);
  const std::size_t numbers = 3 * static_cast<std::size_t>(width);
  wide_row_.resize(numbers + 6 * static_cast<std::size_t>(radius_));
  sum_.resize(numbers);
  rows_.resize(numbers * static_cast<std::size_t>(height));
}

void GaussianBlur::apply(ColorImage& picture) noexcept {
  MUROSIMF_ASSERT(picture.width() == width_ && picture.height() == height_);
  const std::size_t numbers = 3 * static_cast<std::size_t>(width_);
  for (int v = 0; v < height_; ++v) {
    blur_row(picture.row(v), std::span(rows_).subspan(static_cast<std::size_t>(v) * numbers, numbers));
  }
  // two passes of one dimension each: the Gaussian is separable
  for (int v = 0; v < height_; ++v) blur_column(v, picture.row(v));
}

/// Adds a pair of neighbors to sum_. Every product is truncated; sum_ starts with the average loss.
void GaussianBlur::add(const std::uint16_t* before, const std::uint16_t* after, std::uint16_t weight) noexcept {
  std::uint16_t* sum = sum_.data();
  const std::size_t count = sum_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto pair = static_cast<std::uint16_t>(before[i] + after[i]);
    sum[i] = static_cast<std::uint16_t>(sum[i] + (std::uint32_t{pair} * weight >> 16));
  }
}

void GaussianBlur::blur_row(std::span<const Rgb> row, std::span<std::uint16_t> to) noexcept {
  MUROSIMF_ASSERT(row.size() == static_cast<std::size_t>(width_) && to.size() == sum_.size());
  auto* wide = wide_row_.data();
  for (int u = -radius_; u < width_ + radius_; ++u) {
    const Rgb& color = row[static_cast<std::size_t>(std::clamp(u, 0, width_ - 1))];
    for (const std::uint8_t level : {color.red, color.green, color.blue}) {
      *wide++ = static_cast<std::uint16_t>(level << fraction_bits);
    }
  }
  std::ranges::fill(sum_, static_cast<std::uint16_t>(radius_ / 2));
  const std::uint16_t* center = wide_row_.data() + 3 * static_cast<std::size_t>(radius_);
  for (std::size_t i = 1; i < weights_.size(); ++i) add(center - 3 * i, center + 3 * i, weights_[i]);
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = static_cast<std::uint16_t>(sum_[i] + ((std::uint32_t{center[i]} * weights_[0] + 0x8000) >> 16));
  }
}

void GaussianBlur::blur_column(int v, std::span<Rgb> to) noexcept {
  MUROSIMF_ASSERT(v >= 0 && v < height_);
  const auto row = [&](int at) {
    return rows_.data() + static_cast<std::size_t>(std::clamp(at, 0, height_ - 1)) * sum_.size();
  };
  std::ranges::fill(sum_, static_cast<std::uint16_t>(radius_ / 2));
  for (int i = 1; i <= radius_; ++i) add(row(v - i), row(v + i), weights_[static_cast<std::size_t>(i)]);
  const std::uint16_t* center = row(v);
  for (std::size_t u = 0; u < to.size(); ++u) {
    const auto level = [&](std::size_t i) {
      const std::uint32_t fine = sum_[i] + ((std::uint32_t{center[i]} * weights_[0] + 0x8000) >> 16);
      return static_cast<std::uint8_t>(std::min((fine + (1U << (fraction_bits - 1))) >> fraction_bits, 255U));
    };
    to[u] = {level(3 * u), level(3 * u + 1), level(3 * u + 2)};
  }
}

}  // namespace murosimf::imaging
