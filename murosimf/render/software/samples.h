/// samples.h - several samples to a pixel, where a picture has edges: a finer picture, of which means are taken.
///
/// Patterns and lines are means over pixels already, so that one sample does for what is alike in a pixel.
#pragma once

#include "murosimf/imaging/image.h"
#include "murosimf/render/software/surface_buffer.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render::software {

class Samples {
 public:
  /// `count`: 1, 2, 4 or 8.
  explicit Samples(int count);

  /// The view with that many pixels to a pixel.
  [[nodiscard]] sensors::Perspective enlarged(const sensors::Perspective& view) const;
  /// In the finer picture: leaves out the pixels of which all samples show one smooth surface.
  void leave_out_what_is_alike(SurfaceBuffer& fine) const;
  /// The means of sRGB numbers, for the pixels of some rows that are not left out.
  void average(const SurfaceBuffer& samples, const imaging::ColorImage& fine, int first_row, int rows,
               imaging::ColorImage& into) const;

 private:
  void leave_out_group(SurfaceBuffer& fine, int u, int v) const;
  [[nodiscard]] bool is_alike(const SurfaceBuffer& fine, int u, int v) const;
  int across_, down_;
};

}  // namespace murosimf::render::software
