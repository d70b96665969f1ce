/// capsule_along.h - the least capsule about spheres, along a given line.
#pragma once

#include <limits>
#include <span>

#include "murosimf/geometry/volume.h"

namespace murosimf::geometry {

/// Of the capsules about the line through `middle` along the unit vector `axis` that hold all spheres: the thinnest, and
/// of these the shortest.
[[nodiscard]] inline BoundingCapsule capsule_along(const Vec3d& axis, const Vec3d& middle,
                                                   std::span<const BoundingSphere> spheres) {
  double radius = 0;
  for (const BoundingSphere& s : spheres) {
    radius = std::max(radius, norm(tangential(s.center - middle, axis)) + s.radius);
  }
  // it holds a sphere whose center is no farther than `room` from the line between its ends
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const BoundingSphere& s : spheres) {
    const Vec3d across = tangential(s.center - middle, axis);
    const double room = radius - s.radius, along = dot(s.center - middle, axis);
    const double beyond = sqrt(std::max(room * room - dot(across, across), 0.0));
    high = std::max(high, along - beyond);
    low = std::min(low, along + beyond);
  }
  return {middle + 0.5 * (low + high) * axis, 0.5 * std::max(high - low, 0.0) * axis, radius};
}

}  // namespace murosimf::geometry
