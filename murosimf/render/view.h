/// view.h - parallel projection: where a point of the world is in a picture.
#pragma once

#include <cmath>

#include "murosimf/math/mat3.h"

namespace murosimf::render {

/// Looks at `center` from far away.
struct View {
  Vec3d right, up, toward;  ///< [1] axes of the picture in the world; `toward` points to the eye
  Vec3d center;             ///< [m] world, in the middle of the picture
  double scale = 100;       ///< [pixels/m]
  int columns = 0, rows = 0;

  /// x, y [pixels] to the right and down, z [m] towards the eye.
  [[nodiscard]] Vec3d operator()(const Vec3d& p) const {
    const Vec3d d = p - center;
    return {0.5 * columns + scale * dot(right, d), 0.5 * rows - scale * dot(up, d), dot(toward, d)};
  }
};

/// Axes of a view: the eye stands in the direction `azimuth` [rad, counterclockwise from x] at `elevation` [rad] above
/// the ground. (-pi/2, 0) is the view from the right side of whoever looks along x, (-pi/2, pi/2) that from above.
[[nodiscard]] inline View view_from(double azimuth, double elevation) {
  View view;
  view.right = {-std::sin(azimuth), std::cos(azimuth), 0};
  view.toward = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
  view.up = cross(view.toward, view.right);
  return view;
}

}  // namespace murosimf::render
