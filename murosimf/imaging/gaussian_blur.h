/// gaussian_blur.h - a picture out of focus: every pixel becomes the mean of its neighbors, weighted by a Gaussian.
#pragma once

#include <cstdint>
#include <vector>

#include "murosimf/imaging/image.h"

namespace murosimf::imaging {

/// Works on sRGB values, as the paper's post-processing does. Beyond the borders the picture goes on with its last
/// pixels. Weights end at 4 sigma; results are within one level of the exact sum.
class GaussianBlur {
 public:
  /// `sigma` [px] of the Gaussian, for pictures of one size [px]. Throws SetupError if it is not above 0 and at most
  /// 20.
  GaussianBlur(double sigma, int width, int height);

  void apply(ColorImage& picture) noexcept;

 private:
  void blur_row(std::span<const Rgb> row, std::span<std::uint16_t> to) noexcept;
  void blur_column(int v, std::span<Rgb> to) noexcept;
  void add(const std::uint16_t* before, const std::uint16_t* after, std::uint16_t weight) noexcept;

  int radius_, width_, height_;
  std::vector<std::uint16_t> weights_;  ///< of the center and its neighbors, to one side; 65536 is the whole
  std::vector<std::uint16_t> wide_row_, sum_;
  std::vector<std::uint16_t> rows_;  ///< of the picture, blurred along its rows
};

}  // namespace murosimf::imaging
