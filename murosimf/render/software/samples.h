/// samples.h - several samples to a pixel: a finer picture, of which means are taken.
#pragma once

#include "murosimf/imaging/image.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render::software {

class Samples {
 public:
  /// `count`: 1, 2, 4 or 8.
  explicit Samples(int count);

  /// The view with that many pixels to a pixel.
  [[nodiscard]] sensors::Perspective enlarged(const sensors::Perspective& view) const;
  /// The means of sRGB numbers, for some rows.
  void average(const imaging::ColorImage& fine, int first_row, int rows, imaging::ColorImage& into) const;

 private:
  int across_, down_;
};

}  // namespace murosimf::render::software
