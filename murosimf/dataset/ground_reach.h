/// ground_reach.h - how much of the ground a thing takes, seen from above.
#pragma once

#include <span>

#include "murosimf/math/transform.h"
#include "murosimf/model/model.h"
#include "murosimf/model/shape.h"

namespace murosimf::dataset {

/// [m] Radius about the vertical through the base that encloses all joints, and boxes around all shapes: an upper bound. `position` [m] and
/// `orientation` of its objects in the world, one row each. Planes do not count.
[[nodiscard]] double ground_reach(const Model& model, std::span<const Vec3d> position,
                                  std::span<const Mat3d> orientation);

/// A rectangle on the ground.
struct Footprint {
  Vec3d middle;                   ///< [m] world
  double heading = 0;             ///< [rad] of its x
  double half_x = 0, half_y = 0;  ///< [m]

  /// [m] From the point to the rectangle, seen from above; 0 inside.
  [[nodiscard]] double distance(const Vec3d& point) const;
};

/// Of a shape at its place in the world; a plane has none, and is a point.
[[nodiscard]] Footprint footprint_of(const Shape& shape, const Transformd& place);

}  // namespace murosimf::dataset
