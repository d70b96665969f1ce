#include "murosimf/geometry/volume.h"

#include <array>
#include <cmath>

namespace murosimf::geometry {
namespace {

/// Half size of a box along `direction`.
double half_along(const Obb& box, const Vec3d& direction) {
  return dot(componentwise_abs(transposed_times(box.axes, direction)), box.half);
}

double volume_of(const Obb& box) { return box.half.x * box.half.y * box.half.z; }

/// Distance [m] of a point from the segment middle +- half_axis.
double distance_to_segment(const Vec3d& point, const Vec3d& middle, const Vec3d& half_axis) {
  const double square = dot(half_axis, half_axis);
  const double along = square > 0 ? std::clamp(dot(point - middle, half_axis) / square, -1.0, 1.0) : 0.0;
  return norm(point - middle - along * half_axis);
}

}  // namespace

Obb merged(const Obb& a, const Obb& b) {
  const Mat3d& axes = volume_of(a) >= volume_of(b) ? a.axes : b.axes;
  const Aabb box_a{transposed_times(axes, a.center),
                   {half_along(a, axes.x), half_along(a, axes.y), half_along(a, axes.z)}};
  const Aabb box_b{transposed_times(axes, b.center),
                   {half_along(b, axes.x), half_along(b, axes.y), half_along(b, axes.z)}};
  const Aabb both = merged(box_a, box_b);
  return {axes * both.center, axes, both.half};
}

BoundingCapsule merged(const BoundingCapsule& a, const BoundingCapsule& b) {
  const std::array<Vec3d, 4> ends{a.middle - a.half_axis, a.middle + a.half_axis, b.middle - b.half_axis,
                                  b.middle + b.half_axis};
  const std::array<double, 4> radii{a.radius, a.radius, b.radius, b.radius};
  std::size_t first = 0, second = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const Vec3d way = ends[i] - ends[j];
      if (dot(way, way) <= farthest) continue;
      farthest = dot(way, way);
      first = i;
      second = j;
    }
  }
  BoundingCapsule both{0.5 * (ends[first] + ends[second]), 0.5 * (ends[second] - ends[first]), 0};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    both.radius = std::max(both.radius, distance_to_segment(ends[i], both.middle, both.half_axis) + radii[i]);
  }
  return both;
}

}  // namespace murosimf::geometry
