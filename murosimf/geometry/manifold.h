/// manifold.h - where two shapes overlap: one normal and up to eight points.
#pragma once

#include <array>
#include <cstdint>

#include "murosimf/math/insertion_sort.h"
#include "murosimf/math/transform.h"

namespace murosimf::geometry {

struct ManifoldPoint {
  Vec3d point;                ///< [m] world frame, in the middle of the overlap
  double depth = 0;           ///< [m] overlap along the normal, positive
  std::uint32_t feature = 0;  ///< which corners, edges or faces meet; stays the same while the same ones do
};

struct Manifold {
  static constexpr int most_points = 8;

  Vec3d normal;  ///< [1] unit, world frame, from B to A
  int count = 0;
  std::array<ManifoldPoint, most_points> points;  ///< the first `count`; the deepest is exact
};

/// Brings the points into an order that stays the same from step to step.
inline void sort_by_feature(Manifold& manifold) {
  insertion_sort(manifold.points.begin(), manifold.points.begin() + manifold.count,
                 [](const ManifoldPoint& a, const ManifoldPoint& b) { return a.feature < b.feature; });
}

}  // namespace murosimf::geometry
