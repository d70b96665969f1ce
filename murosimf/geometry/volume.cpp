#include "murosimf/geometry/volume.h"

#include <array>
#include <cmath>

#include "murosimf/geometry/capsule_along.h"

namespace murosimf::geometry {
namespace {

/// Half size of a box along `direction`.
double half_along(const Obb& box, const Vec3d& direction) {
  return dot(componentwise_abs(transposed_times(box.axes, direction)), box.half);
}

double volume_of(const Obb& box) { return box.half.x * box.half.y * box.half.z; }

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
  const std::array<BoundingSphere, 4> ends{BoundingSphere{a.middle - a.half_axis, a.radius},
                                           BoundingSphere{a.middle + a.half_axis, a.radius},
                                           BoundingSphere{b.middle - b.half_axis, b.radius},
                                           BoundingSphere{b.middle + b.half_axis, b.radius}};
  Vec3d longest;
  double square = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      const Vec3d way = ends[j].center - ends[i].center;
      if (dot(way, way) <= square) continue;
      square = dot(way, way);
      longest = way;
    }
  }
  const Vec3d axis = square > 0 ? (1 / sqrt(square)) * longest : Vec3d{0, 0, 1};
  // the line may run beside the ends that gave its direction: through the middle of all
  const Vec3d middle = 0.25 * (ends[0].center + ends[1].center + ends[2].center + ends[3].center);
  return capsule_along(axis, middle, ends);
}

}  // namespace murosimf::geometry
