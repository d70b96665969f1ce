/// volume.h - four kinds of bounding volumes: plain data, how they move with a body, and how two become one.
///
/// Paper 5: spheres are the default; the choice is between tightness and the cost of moving and testing a volume.
#pragma once

#include <algorithm>

#include "murosimf/geometry/manifold.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

struct BoundingSphere {
  Vec3d center;       ///< [m]
  double radius = 0;  ///< [m]
};
/// Box along the axes of its frame.
struct Aabb {
  Vec3d center;  ///< [m]
  Vec3d half;    ///< [m] half sizes
};
/// Box in any orientation.
struct Obb {
  Vec3d center;  ///< [m]
  Mat3d axes;    ///< columns: its axes
  Vec3d half;    ///< [m] half sizes along them
};
struct BoundingCapsule {
  Vec3d middle;       ///< [m]
  Vec3d half_axis;    ///< [m] from the middle to the center of one end
  double radius = 0;  ///< [m]
};

/// Tight bound of a shape that stands at `at` in some frame, in that frame. The shape must be finite: no plane.
template <class V>
[[nodiscard]] V fit(const Shape& shape, const Transformd& at);
template <>
[[nodiscard]] BoundingSphere fit<BoundingSphere>(const Shape& shape, const Transformd& at);
template <>
[[nodiscard]] Aabb fit<Aabb>(const Shape& shape, const Transformd& at);
template <>
[[nodiscard]] Obb fit<Obb>(const Shape& shape, const Transformd& at);
template <>
[[nodiscard]] BoundingCapsule fit<BoundingCapsule>(const Shape& shape, const Transformd& at);

inline Vec3d componentwise_abs(const Vec3d& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }

// moved: bound in the world of a volume that is fixed to a body with its origin at r [m] and axes R.

[[nodiscard]] inline BoundingSphere moved(const BoundingSphere& local, const Vec3d& r, const Mat3d& R) {
  return {r + R * local.center, local.radius};
}
[[nodiscard]] inline Aabb moved(const Aabb& local, const Vec3d& r, const Mat3d& R) {
  const Mat3d spread{componentwise_abs(R.x), componentwise_abs(R.y), componentwise_abs(R.z)};
  return {r + R * local.center, spread * local.half};
}
[[nodiscard]] inline Obb moved(const Obb& local, const Vec3d& r, const Mat3d& R) {
  return {r + R * local.center, R * local.axes, local.half};
}
[[nodiscard]] inline BoundingCapsule moved(const BoundingCapsule& local, const Vec3d& r, const Mat3d& R) {
  return {r + R * local.middle, R * local.half_axis, local.radius};
}

// grown: encloses everything within `margin` [m] of the volume.

[[nodiscard]] inline BoundingSphere grown(const BoundingSphere& v, double margin) {
  return {v.center, v.radius + margin};
}
[[nodiscard]] inline Aabb grown(const Aabb& v, double margin) {
  return {v.center, v.half + Vec3d{margin, margin, margin}};
}
[[nodiscard]] inline Obb grown(const Obb& v, double margin) {
  return {v.center, v.axes, v.half + Vec3d{margin, margin, margin}};
}
[[nodiscard]] inline BoundingCapsule grown(const BoundingCapsule& v, double margin) {
  return {v.middle, v.half_axis, v.radius + margin};
}

// merged: encloses both.

/// The smallest sphere about two.
[[nodiscard]] inline BoundingSphere merged(const BoundingSphere& a, const BoundingSphere& b) {
  const Vec3d way = b.center - a.center;
  const double square = dot(way, way), larger = b.radius - a.radius;
  if (larger * larger >= square) return larger > 0 ? b : a;  // one holds the other
  const double distance = sqrt(square);
  // how far the center moves from a's to b's; written so that root and quotient do not wait for each other
  const double part = 0.5 + 0.5 * (larger / square) * distance;
  return {a.center + part * way, 0.5 * (distance + a.radius + b.radius)};
}
[[nodiscard]] inline Aabb merged(const Aabb& a, const Aabb& b) {
  const Vec3d low_a = a.center - a.half, low_b = b.center - b.half;
  const Vec3d high_a = a.center + a.half, high_b = b.center + b.half;
  const Vec3d low{std::min(low_a.x, low_b.x), std::min(low_a.y, low_b.y), std::min(low_a.z, low_b.z)};
  const Vec3d high{std::max(high_a.x, high_b.x), std::max(high_a.y, high_b.y), std::max(high_a.z, high_b.z)};
  return {0.5 * (low + high), 0.5 * (high - low)};
}
/// In the orientation of the bigger one.
[[nodiscard]] Obb merged(const Obb& a, const Obb& b);
/// Along the line between those two of the four ends that are farthest from each other, through the middle of all.
[[nodiscard]] BoundingCapsule merged(const BoundingCapsule& a, const BoundingCapsule& b);

// size: radius [m] of the sphere around a volume, to compare volumes of all kinds.

[[nodiscard]] inline double size(const BoundingSphere& v) { return v.radius; }
[[nodiscard]] inline double size(const Aabb& v) { return norm(v.half); }
[[nodiscard]] inline double size(const Obb& v) { return norm(v.half); }
[[nodiscard]] inline double size(const BoundingCapsule& v) { return norm(v.half_axis) + v.radius; }

[[nodiscard]] inline const BoundingSphere& sphere_around(const BoundingSphere& v) { return v; }
[[nodiscard]] inline BoundingSphere sphere_around(const Aabb& v) { return {v.center, size(v)}; }
[[nodiscard]] inline BoundingSphere sphere_around(const Obb& v) { return {v.center, size(v)}; }
[[nodiscard]] inline BoundingSphere sphere_around(const BoundingCapsule& v) { return {v.middle, size(v)}; }

}  // namespace murosimf::geometry
