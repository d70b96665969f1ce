/// volume_fixtures.h - bounding volumes of all kinds in random places, and points that they hold.
#pragma once

#include <tuple>

#include "murosimf/geometry/volume_overlap.h"
#include "tests/fixtures.h"

namespace murosimf::fixtures {

using geometry::Aabb, geometry::BoundingCapsule, geometry::BoundingSphere, geometry::Obb;
using Volumes = std::tuple<BoundingSphere, Aabb, Obb, BoundingCapsule>;

/// How far [m] a point is outside a volume, negative inside.
inline double outside(const BoundingSphere& v, const Vec3d& p) { return norm(p - v.center) - v.radius; }
inline double outside(const Aabb& v, const Vec3d& p) { return outside(Box{v.half}, p - v.center); }
inline double outside(const Obb& v, const Vec3d& p) {
  return outside(Box{v.half}, transposed_times(v.axes, p - v.center));
}
inline double outside(const BoundingCapsule& v, const Vec3d& p) {
  const double half = norm(v.half_axis);
  const Vec3d along = half > 0 ? (1 / half) * v.half_axis : Vec3d{0, 0, 1};
  const double z = dot(along, p - v.middle);
  return std::hypot(norm(cross(along, p - v.middle)), std::fmax(std::fabs(z) - half, 0)) - v.radius;
}

/// A volume of a random size, within 1 m.
template <class V>
V random_volume(Dice& dice);
template <>
inline BoundingSphere random_volume(Dice& dice) {
  return {dice.vector(1), dice.uniform(0.05, 0.5)};
}
template <>
inline Aabb random_volume(Dice& dice) {
  return {dice.vector(1), {dice.uniform(0.01, 0.5), dice.uniform(0.01, 0.5), dice.uniform(0.01, 0.5)}};
}
template <>
inline Obb random_volume(Dice& dice) {
  const Aabb box = random_volume<Aabb>(dice);
  return {box.center, dice.turn(), box.half};
}
template <>
inline BoundingCapsule random_volume(Dice& dice) {
  return {dice.vector(1), dice.uniform(0, 0.5) * dice.unit(), dice.uniform(0.02, 0.3)};
}

/// A point in the volume, often on its surface.
inline Vec3d point_in(const BoundingSphere& v, Dice& dice) {
  return v.center + (dice.chance(0.5) ? 1.0 : dice.uniform(0, 1)) * v.radius * dice.unit();
}
inline Vec3d point_in(const Obb& v, Dice& dice) {
  const auto part = [&](double half) { return half * std::clamp(dice.uniform(-1.5, 1.5), -1.0, 1.0); };
  const double x = part(v.half.x), y = part(v.half.y);
  return v.center + v.axes * Vec3d{x, y, part(v.half.z)};
}
inline Vec3d point_in(const Aabb& v, Dice& dice) { return point_in(geometry::detail::as_obb(v), dice); }
inline Vec3d point_in(const BoundingCapsule& v, Dice& dice) {
  const Vec3d on_axis = v.middle + std::clamp(dice.uniform(-1.5, 1.5), -1.0, 1.0) * v.half_axis;
  return point_in(BoundingSphere{on_axis, v.radius}, dice);
}

inline Vec3d middle(const BoundingSphere& v) { return v.center; }
inline Vec3d middle(const Aabb& v) { return v.center; }
inline Vec3d middle(const Obb& v) { return v.center; }
inline Vec3d middle(const BoundingCapsule& v) { return v.middle; }

/// The same volume elsewhere.
inline void shift(BoundingSphere& v, const Vec3d& by) { v.center += by; }
inline void shift(Aabb& v, const Vec3d& by) { v.center += by; }
inline void shift(Obb& v, const Vec3d& by) { v.center += by; }
inline void shift(BoundingCapsule& v, const Vec3d& by) { v.middle += by; }

/// The point of a volume nearest to p.
inline Vec3d nearest(const BoundingSphere& v, const Vec3d& p) {
  const double distance = norm(p - v.center);
  return distance <= v.radius ? p : v.center + (v.radius / distance) * (p - v.center);
}
inline Vec3d nearest(const Obb& v, const Vec3d& p) {
  const Vec3d q = transposed_times(v.axes, p - v.center);
  return v.center + v.axes * Vec3d{std::clamp(q.x, -v.half.x, v.half.x), std::clamp(q.y, -v.half.y, v.half.y),
                                   std::clamp(q.z, -v.half.z, v.half.z)};
}
inline Vec3d nearest(const Aabb& v, const Vec3d& p) { return nearest(geometry::detail::as_obb(v), p); }
inline Vec3d nearest(const BoundingCapsule& v, const Vec3d& p) {
  const double square = dot(v.half_axis, v.half_axis);
  const double t = square > 0 ? std::clamp(dot(p - v.middle, v.half_axis) / square, -1.0, 1.0) : 0;
  return nearest(BoundingSphere{v.middle + t * v.half_axis, v.radius}, p);
}

/// Distance [m] of two volumes by going to and fro between their nearest points, which converges for convex sets (von
/// Neumann's alternating projections): never below the true one.
template <class V, class W>
double distance_by_projections(const V& v, const W& w) {
  Vec3d p = nearest(v, {}), q;
  for (int i = 0; i < 2000; ++i) {
    q = nearest(w, p);
    p = nearest(v, q);
  }
  return norm(p - q);
}

/// Calls f(V, W) with default values of all 16 pairs of kinds.
template <class F>
void for_all_pairs_of_kinds(const F& f) {
  std::apply(
      [&](const auto&... v) {
        const auto row = [&](const auto& one) { (f(one, v), ...); };
        (row(v), ...);
      },
      Volumes{});
}
template <class F>
void for_all_kinds(const F& f) {
  std::apply([&](const auto&... v) { (f(v), ...); }, Volumes{});
}

}  // namespace murosimf::fixtures
