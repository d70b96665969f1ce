/// image.h - pictures: rows of pixels, from the top left.
///
/// Pixel coordinates (u, v): u to the right, v down; the center of the top left pixel is (0, 0), as in OpenCV and ROS,
/// so a picture reaches from -0.5 to width - 0.5.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::imaging {

template <class Pixel>
class Image {
 public:
  Image() = default;
  Image(int width, int height, const Pixel& fill = {})
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height, fill) {
    MUROSIMF_ASSERT(width >= 0 && height >= 0);
  }

  [[nodiscard]] int width() const { return width_; }    ///< [px]
  [[nodiscard]] int height() const { return height_; }  ///< [px]
  [[nodiscard]] bool empty() const { return pixels_.empty(); }
  [[nodiscard]] Pixel& operator()(int u, int v) { return pixels_[index(u, v)]; }
  [[nodiscard]] const Pixel& operator()(int u, int v) const { return pixels_[index(u, v)]; }
  [[nodiscard]] std::span<Pixel> row(int v) { return pixels().subspan(index(0, v), static_cast<std::size_t>(width_)); }
  [[nodiscard]] std::span<const Pixel> row(int v) const {
    return pixels().subspan(index(0, v), static_cast<std::size_t>(width_));
  }
  /// All, row by row from the top.
  [[nodiscard]] std::span<Pixel> pixels() { return pixels_; }
  [[nodiscard]] std::span<const Pixel> pixels() const { return pixels_; }

  void state(StateArchive& archive) { archive(width_, height_, pixels_); }

 private:
  [[nodiscard]] std::size_t index(int u, int v) const {
    MUROSIMF_ASSERT(u >= 0 && v >= 0 && v < height_);
    return static_cast<std::size_t>(v) * width_ + u;
  }

  int width_ = 0, height_ = 0;
  std::vector<Pixel> pixels_;
};

/// Makes a new image unless it has this size; its pixels are to be written next.
template <class Pixel>
void fit(Image<Pixel>& image, int width, int height) {
  if (image.width() != width || image.height() != height) image = Image<Pixel>(width, height);
}

/// sRGB, as files and screens have it.
struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

using ColorImage = Image<Rgb>;
using GrayImage = Image<std::uint8_t>;  ///< brightness, or a Bayer mosaic
using DepthImage = Image<float>;        ///< [m] along the optical axis; infinite where nothing is
using NumberImage = Image<std::uint16_t>;
using LabelImage = NumberImage;  ///< what is seen (sensors/view_source.h)

}  // namespace murosimf::imaging
