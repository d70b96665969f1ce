/// distance.h - how far two shapes are from each other.
#pragma once

#include "murosimf/geometry/manifold.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

struct Gap {
  double distance = 0;  ///< [m] negative: the depth of their overlap
  Vec3d on_a, on_b;     ///< [m] world frame: points of either surface that are this far from each other
};

/// Overlapping shapes: the two points that the least penetration shift brings together. Relative error of a distance 1e-14, of
/// the points on curved surfaces 1e-7; of a depth as in `collide`. Two planes are infinitely far apart, and there are no
/// points.
[[nodiscard]] Gap distance(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b);

}  // namespace murosimf::geometry
