/// exposure.h - pictures exposed longer or shorter, and means of pictures: sums of light, not of sRGB values.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "murosimf/imaging/image.h"

namespace murosimf::imaging {

/// Another exposure: all light times a factor; what is above white becomes white.
class Exposure {
 public:
  /// Throws SetupError if `gain` is not above 0 and finite.
  explicit Exposure(double gain);

  void apply(ColorImage& picture) const noexcept;

 private:
  std::array<std::uint8_t, 256> values_{};  ///< what each value becomes
};

/// The mean light of several pictures: what a sensor sees while something moves.
class LightMean {
 public:
  /// For pictures of one size [px].
  LightMean(int width, int height);

  /// Forgets what was added.
  void clear() noexcept;
  /// Adds a picture; up to 65536 of them.
  void add(const ColorImage& picture) noexcept;
  /// The mean of what was added; black if there is nothing.
  void write(ColorImage& picture) const noexcept;

 private:
  std::vector<std::uint32_t> sums_;  ///< red, green and blue light of every pixel (imaging/srgb.h)
  std::uint32_t count_ = 0;
};

}  // namespace murosimf::imaging
