#include "murosimf/imaging/image_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "murosimf/imaging/srgb.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::imaging {
namespace {

constexpr std::size_t bins = 4096;
constexpr int bin_bits = 12;

/// z so that a standard normal number is below it with probability p: by bisection of the distribution.
double normal_quantile(double p) {
  MUROSIMF_ASSERT(p > 0 && p < 1);
  double low = -10, high = 10;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < p ? low : high) = middle;
  }
  return low;
}

/// Normal numbers of equal probability, scaled to a variance of exactly 1.
const std::vector<float>& normals() {
  static const auto table = [] {
    std::vector<double> exact;
    exact.reserve(bins);
    double squares = 0;
    for (std::size_t i = 0; i < bins; ++i) {
      exact.push_back(normal_quantile((static_cast<double>(i) + 0.5) / bins));
      squares += exact.back() * exact.back();
    }
    const double scale = std::sqrt(bins / squares);
    std::vector<float> made;
    made.reserve(bins);
    for (const double z : exact) made.push_back(static_cast<float>(scale * z));
    return made;
  }();
  return table;
}

/// The n-th of a sequence of 64 random bits. Source: Steele, Lea, Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014 (SplitMix64).
std::uint64_t random_bits(std::uint64_t start, std::uint64_t n) noexcept {
  std::uint64_t z = start + n * 0x9e3779b97f4a7c15;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  return z ^ z >> 31;
}

void check(std::string_view name, double value) {
  if (!(value >= 0 && value <= 1)) {
    throw SetupError(fmt::format("the {} noise is {}; it must be 0 to 1, of white's light", name, value));
  }
}

}  // namespace

ImageNoise::ImageNoise(const ImageNoiseSpec& spec, const RandomStream& stream) : stream_(stream) {
  check("shot", spec.shot);
  check("read", spec.read);
  for (std::size_t i = 0; i < deviation_.size(); ++i) {
    const double light = light_of_srgb(static_cast<double>(i) / 255);
    deviation_[i] = static_cast<float>(full_light * std::sqrt(spec.shot * spec.shot * light + spec.read * spec.read));
  }
}

void ImageNoise::make_tables() {
  static_cast<void>(normals());
  static_cast<void>(value_table());
}

void ImageNoise::apply(ColorImage& picture, std::uint64_t number) const noexcept {
  constexpr double two_to_53 = 9007199254740992.0;
  constexpr float half = 0.5F;  // conversion to whole numbers truncates
  const auto start = static_cast<std::uint64_t>(stream_.uniform(number) * two_to_53) << 11;
  const float* normal = normals().data();
  const std::uint16_t* light = light_table().data();
  const std::uint8_t* values = value_table().data();
  const auto noisy = [&](std::uint8_t value, std::uint64_t bits) {
    const float sum = static_cast<float>(light[value]) + deviation_[value] * normal[bits % bins];
    return values[static_cast<std::size_t>(half + std::clamp(sum, 0.0F, static_cast<float>(full_light)))];
  };
  std::uint64_t n = 0;
  for (Rgb& color : picture.pixels()) {
    // one random number for all three channels: 12 bits each select from the table
    const std::uint64_t bits = random_bits(start, n++);
    color = {noisy(color.red, bits), noisy(color.green, bits >> bin_bits), noisy(color.blue, bits >> 2 * bin_bits)};
  }
}

}  // namespace murosimf::imaging
