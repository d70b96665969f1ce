/// viewpoint.h - the camera of one picture, as its annotations use it.
#pragma once

#include <optional>

#include "murosimf/imaging/lens.h"
#include "murosimf/math/mat3.h"

namespace murosimf::dataset {

struct Viewpoint {
  imaging::Lens lens;
  Vec3d eye;   ///< [m] world
  Mat3d axes;  ///< optical axes to world axes

  /// [m] A point of the world in the optical frame.
  [[nodiscard]] Vec3d in_camera(const Vec3d& point) const { return transposed_times(axes, point - eye); }
  /// What the pixel shows at that depth [m] along the optical axis, in the world; nothing where the lens sees nothing.
  [[nodiscard]] std::optional<Vec3d> place(const imaging::Pixel& pixel, double depth) const {
    const auto ray = lens.ray(pixel);
    if (!ray || ray->z == 0) return std::nullopt;
    return eye + axes * ((depth / ray->z) * *ray);
  }
};

}  // namespace murosimf::dataset
