#include "murosimf/geometry/distance.h"

#include <algorithm>
#include <limits>

#include "murosimf/geometry/collide.h"
#include "murosimf/geometry/gjk.h"
#include "murosimf/geometry/segments.h"
#include "murosimf/geometry/sphere_contact.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

Gap swapped(const Gap& gap) { return {gap.distance, gap.on_b, gap.on_a}; }

/// B: the plane.
Gap above_plane(const Shape& a, const Transformd& at_a, const Transformd& at_b) {
  const Vec3d n = at_b.orientation.z;
  const Vec3d lowest = at_a.position + at_a.orientation * support(a, transposed_times(at_a.orientation, -n));
  const double height = dot(n, lowest - at_b.position);
  return {height, lowest, lowest - height * n};
}

Gap overlap(const Manifold& found) {
  MUROSIMF_ASSERT(found.count > 0);
  const auto deepest = std::max_element(found.points.begin(), found.points.begin() + found.count,
                                        [](const auto& p, const auto& q) { return p.depth < q.depth; });
  const Vec3d half = 0.5 * deepest->depth * found.normal;
  return {-deepest->depth, deepest->point - half, deepest->point + half};
}

/// A sphere that is apart from B: a sphere about the same center that is large enough to touch B gives the direction.
Gap beside_sphere(const Sphere& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
  const Vec3d center = transposed_times(at_b.orientation, at_a.position - at_b.position);
  const double far = 2 * (norm(center) + bounding_radius(b));
  const auto contact = sphere_contact(center, far, b);
  MUROSIMF_ASSERT(contact);
  const double distance = far - contact->depth - a.radius;
  const Vec3d on_b = at_b.position + at_b.orientation * contact->point;
  return {distance, on_b + distance * (at_b.orientation * contact->normal), on_b};
}

/// Two cores with margins, apart.
Gap between(double margin_a, double margin_b, const CoreGap& gap) {
  if (!(gap.distance > 0)) return {0, gap.on_a, gap.on_b};
  const Vec3d n = gap.direction();
  return {gap.distance - margin_a - margin_b, gap.on_a - margin_a * n, gap.on_b + margin_b * n};
}

CoreGap gap_of_axes(const Capsule& a, const Transformd& at_a, const Capsule& b, const Transformd& at_b) {
  const Segment u{at_a.position, a.half_length * at_a.orientation.z};
  const Segment v{at_b.position, b.half_length * at_b.orientation.z};
  const auto [s, t] = closest_places(u, v);
  const Vec3d way = u.at(s) - v.at(t);
  return {u.at(s), v.at(t), way, norm(way)};
}

}  // namespace

Gap distance(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
  const bool plane_a = std::holds_alternative<Plane>(a), plane_b = std::holds_alternative<Plane>(b);
  if (plane_a && plane_b) return {std::numeric_limits<double>::infinity(), {}, {}};
  if (plane_a) return swapped(above_plane(b, at_b, at_a));
  if (plane_b) return above_plane(a, at_a, at_b);
  Manifold found;
  if (collide(a, at_a, b, at_b, found)) return overlap(found);
  if (const auto* sphere = std::get_if<Sphere>(&a)) return beside_sphere(*sphere, at_a, b, at_b);
  if (const auto* sphere = std::get_if<Sphere>(&b)) return swapped(beside_sphere(*sphere, at_b, a, at_a));
  const Body body_a(a, at_a), body_b(b, at_b);
  const auto *capsule_a = std::get_if<Capsule>(&a), *capsule_b = std::get_if<Capsule>(&b);
  const CoreGap gap = capsule_a && capsule_b ? gap_of_axes(*capsule_a, at_a, *capsule_b, at_b)
                                             : gap_of_cores(body_a, {}, body_b, at_a.position - at_b.position);
  return between(body_a.margin(), body_b.margin(), gap);
}

}  // namespace murosimf::geometry
