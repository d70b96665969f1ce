/// volume_overlap.h - do two bounding volumes overlap, how far are they apart, and does a ray enter one.
///
/// Every combination of the four kinds is exact but for rounding, except where said otherwise.
#pragma once

#include "murosimf/geometry/ray.h"
#include "murosimf/geometry/volume.h"

namespace murosimf::geometry {

namespace detail {

/// Squared distance [m^2] of a point from a box about the origin, along its axes.
inline double square_to_box(const Vec3d& point, const Vec3d& half) {
  const Vec3d out{std::max(abs(point.x) - half.x, 0.0), std::max(abs(point.y) - half.y, 0.0),
                  std::max(abs(point.z) - half.z, 0.0)};
  return dot(out, out);
}
inline double square_between(const Vec3d& point, const Aabb& box) {
  return square_to_box(point - box.center, box.half);
}
inline double square_between(const Vec3d& point, const Obb& box) {
  return square_to_box(transposed_times(box.axes, point - box.center), box.half);
}
/// To the line between the ends of a capsule.
inline double square_between(const Vec3d& point, const BoundingCapsule& capsule) {
  const Vec3d way = point - capsule.middle;
  const double square = dot(capsule.half_axis, capsule.half_axis);
  const double along = square > 0 ? std::clamp(dot(way, capsule.half_axis) / square, -1.0, 1.0) : 0.0;
  const Vec3d across = way - along * capsule.half_axis;
  return dot(across, across);
}
/// Between the lines of two capsules. Source: Ericson, Real-Time Collision Detection, 2005, sec. 5.1.9.
double square_between(const BoundingCapsule& a, const BoundingCapsule& b);
/// From the line of a capsule to a box.
double square_between(const BoundingCapsule& capsule, const Obb& box);
/// The six axes of two boxes, which give a lower bound of the distance [m]: negative if none parts them.
double face_gap(const Obb& a, const Obb& b);

inline Obb as_obb(const Aabb& box) { return {box.center, {}, box.half}; }
inline double radius_of(const Aabb&) { return 0; }
inline double radius_of(const Obb&) { return 0; }
inline double radius_of(const BoundingCapsule& capsule) { return capsule.radius; }

inline bool within(double square, double distance) { return square <= distance * distance; }

}  // namespace detail

// overlap: never false if the two share a point.

[[nodiscard]] inline bool overlap(const BoundingSphere& a, const BoundingSphere& b) {
  const Vec3d way = a.center - b.center;
  return detail::within(dot(way, way), a.radius + b.radius);
}
template <class V>
[[nodiscard]] bool overlap(const BoundingSphere& a, const V& b) {
  return detail::within(detail::square_between(a.center, b), a.radius + detail::radius_of(b));
}
[[nodiscard]] inline bool overlap(const Aabb& a, const Aabb& b) {
  const Vec3d way = componentwise_abs(a.center - b.center), sum = a.half + b.half;
  return way.x <= sum.x && way.y <= sum.y && way.z <= sum.z;
}
/// All 15 directions that can part two boxes. Source: Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996.
[[nodiscard]] bool overlap(const Obb& a, const Obb& b);
[[nodiscard]] inline bool overlap(const Aabb& a, const Obb& b) { return overlap(detail::as_obb(a), b); }
[[nodiscard]] inline bool overlap(const BoundingCapsule& a, const BoundingCapsule& b) {
  return detail::within(detail::square_between(a, b), a.radius + b.radius);
}
[[nodiscard]] inline bool overlap(const BoundingCapsule& a, const Obb& b) {
  return detail::within(detail::square_between(a, b), a.radius);
}
[[nodiscard]] inline bool overlap(const BoundingCapsule& a, const Aabb& b) { return overlap(a, detail::as_obb(b)); }
[[nodiscard]] inline bool overlap(const Aabb& a, const BoundingSphere& b) { return overlap(b, a); }
[[nodiscard]] inline bool overlap(const Obb& a, const BoundingSphere& b) { return overlap(b, a); }
[[nodiscard]] inline bool overlap(const BoundingCapsule& a, const BoundingSphere& b) { return overlap(b, a); }
[[nodiscard]] inline bool overlap(const Obb& a, const Aabb& b) { return overlap(b, a); }
[[nodiscard]] inline bool overlap(const Obb& a, const BoundingCapsule& b) { return overlap(b, a); }
[[nodiscard]] inline bool overlap(const Aabb& a, const BoundingCapsule& b) { return overlap(b, a); }

// gap: lower bound [m] of the distance between what two volumes enclose; 0 if they overlap. That of two boxes of
// different axes may be less than their distance.

[[nodiscard]] inline double gap(const BoundingSphere& a, const BoundingSphere& b) {
  return std::max(norm(a.center - b.center) - a.radius - b.radius, 0.0);
}
template <class V>
[[nodiscard]] double gap(const BoundingSphere& a, const V& b) {
  return std::max(sqrt(detail::square_between(a.center, b)) - a.radius - detail::radius_of(b), 0.0);
}
[[nodiscard]] inline double gap(const Aabb& a, const Aabb& b) {
  return sqrt(detail::square_to_box(a.center - b.center, a.half + b.half));
}
[[nodiscard]] inline double gap(const Obb& a, const Obb& b) { return std::max(detail::face_gap(a, b), 0.0); }
[[nodiscard]] inline double gap(const Aabb& a, const Obb& b) { return gap(detail::as_obb(a), b); }
[[nodiscard]] inline double gap(const BoundingCapsule& a, const BoundingCapsule& b) {
  return std::max(sqrt(detail::square_between(a, b)) - a.radius - b.radius, 0.0);
}
[[nodiscard]] inline double gap(const BoundingCapsule& a, const Obb& b) {
  return std::max(sqrt(detail::square_between(a, b)) - a.radius, 0.0);
}
[[nodiscard]] inline double gap(const BoundingCapsule& a, const Aabb& b) { return gap(a, detail::as_obb(b)); }
[[nodiscard]] inline double gap(const Aabb& a, const BoundingSphere& b) { return gap(b, a); }
[[nodiscard]] inline double gap(const Obb& a, const BoundingSphere& b) { return gap(b, a); }
[[nodiscard]] inline double gap(const BoundingCapsule& a, const BoundingSphere& b) { return gap(b, a); }
[[nodiscard]] inline double gap(const Obb& a, const Aabb& b) { return gap(b, a); }
[[nodiscard]] inline double gap(const Obb& a, const BoundingCapsule& b) { return gap(b, a); }
[[nodiscard]] inline double gap(const Aabb& a, const BoundingCapsule& b) { return gap(b, a); }

// ray_enters: true if a ray has a point in the volume that is at most `limit` [m] from its origin.

[[nodiscard]] bool ray_enters(const BoundingSphere& v, const Ray& ray, double limit);
[[nodiscard]] bool ray_enters(const Aabb& v, const Ray& ray, double limit);
[[nodiscard]] bool ray_enters(const Obb& v, const Ray& ray, double limit);
[[nodiscard]] bool ray_enters(const BoundingCapsule& v, const Ray& ray, double limit);

}  // namespace murosimf::geometry
