/// lens_views.h - which perspective views a picture through a lens is made of.
///
/// A renderer makes pictures in which straight lines stay straight. One such view does for rays near the axis; farther
/// out it stretches without end, so there the front, side and back faces of a cube take over, each cut to what the
/// lens sees of it.
#pragma once

#include <cstdint>
#include <vector>

#include "murosimf/imaging/lens.h"
#include "murosimf/math/mat3.h"

namespace murosimf::imaging {

/// A perspective view. Its frame is optical: x right, y down, z forward.
struct ViewWindow {
  Mat3d axes{};                                     ///< rotation, from the view's frame to the camera's optical frame
  double left = 0, right = 0, top = 0, bottom = 0;  ///< borders: x / z and y / z, left < right and top < bottom
  int width = 0, height = 0;                        ///< [px]

  /// The place at (x / z, y / z) in the view's picture; pixels as in imaging/image.h.
  [[nodiscard]] Pixel pixel(double x, double y) const {
    return {(x - left) / (right - left) * width - 0.5, (y - top) / (bottom - top) * height - 0.5};
  }
};

/// Where a pixel of the picture looks: x / z and y / z in the view of that number; no view beyond the fold of the lens.
struct ViewPlace {
  static constexpr int none = -1;
  float x = 0, y = 0;
  int view = none;
};

struct LensViews {
  std::vector<ViewWindow> windows;
  std::vector<ViewPlace> places;  ///< of all pixels, row by row
};

/// One view if all rays are within 60 degrees of the axis, else up to six. `resolution`: pixels of a view per pixel of
/// the picture at the finest place of the view. A view is at most 8192 pixels wide and high. Its borders leave room for
/// the neighbors that interpolation needs: the pixels left and above, two right, and one below of every place.
[[nodiscard]] LensViews choose_views(const Lens& lens, double resolution);

}  // namespace murosimf::imaging
