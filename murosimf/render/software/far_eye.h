/// far_eye.h - an eye for either kind of projection: parallel rays are those of an eye far away.
#pragma once

#include <algorithm>

#include "murosimf/render/projection.h"

namespace murosimf::render::software {

/// From so many sizes of the picture away: a body as far behind the middle as half of the picture is wide looks smaller by a thousandth.
/// Farther away, the depths of single precision would be coarser than that: 1 / z has seven digits.
inline constexpr double far_away = 500;

struct FarEye {
  explicit FarEye(const Projection& projection)
      : view(projection.window), around(projection.window.eye), parallel(projection.parallel) {
    if (!parallel) return;
    distance = far_away * std::max(view.right - view.left, view.bottom - view.top);
    view.eye = around - distance * view.axes.z;
    for (double* border : {&view.left, &view.right, &view.top, &view.bottom}) *border /= distance;
  }
  /// Whether the ground is seen from its edge.
  [[nodiscard]] bool is_level() const { return parallel && std::abs(view.axes.z.z) <= level_sine; }

  sensors::Perspective view;
  Vec3d around;         ///< [m] the ground reaches floor_reach from here: the eye, or the middle of a parallel picture
  double distance = 0;  ///< [m] by which depths are too large
  bool parallel = false;
};

}  // namespace murosimf::render::software
