#include "murosimf/collision/body_pairs.h"

#include <algorithm>

#include "murosimf/collision/sphere_contact.h"

namespace murosimf::collision {

void append_hash(Hasher& hasher, const PairSet& set) {
  hasher.add(static_cast<std::uint64_t>(set.points.size()));
  for (const PairContact& point : set.points) {
    hasher.add(point.key);
    append_hash(hasher, static_cast<const ContactPoint&>(point));
    for (const Vec3d& v :
         {point.point, point.normal, point.force, point.arm_a, point.arm_b, point.velocity_a, point.velocity_b}) {
      append_hash(hasher, v);
    }
    hasher.add(point.normal_damping);
    hasher.add(point.tangent_damping);
  }
}

namespace {

bool is_sphere(const Shape& shape) { return std::holds_alternative<Sphere>(shape); }

/// Closest points of two segments: their places along them, from -1 to 1.
struct Closest {
  double s, t;
};
/// p, q [m] middles, u, v [m] half segments.
Closest closest_points(const Vec3d& p, const Vec3d& u, const Vec3d& q, const Vec3d& v) {
  const Vec3d w = p - q;
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  const double parallel = uu * vv - uv * uv;
  const auto limit = [](double x) { return std::clamp(x, -1.0, 1.0); };
  double s = parallel > 1e-12 * uu * vv ? limit((uv * vw - vv * uw) / parallel) : 0;
  double t = vv > 0 ? limit((uv * s + vw) / vv) : 0;
  s = uu > 0 ? limit((uv * t - uw) / uu) : 0;
  return {s, t};
}

std::optional<Touch> touch_of_balls(const Vec3d& a, double radius_a, const Vec3d& b, double radius_b) {
  const Vec3d way = a - b;
  const double distance = norm(way);
  const double depth = radius_a + radius_b - distance;
  if (!(depth > 0)) return std::nullopt;
  const Vec3d normal = distance > 0 ? (1 / distance) * way : Vec3d{0, 0, 1};
  return Touch{b + (radius_b - 0.5 * depth) * normal, normal, depth};
}

std::optional<Touch> touch_of_capsules(const PlacedInWorld& a, const PlacedInWorld& b) {
  const auto& [radius_a, half_a] = std::get<Capsule>(*a.shape);
  const auto& [radius_b, half_b] = std::get<Capsule>(*b.shape);
  const Vec3d u = half_a * a.orientation.z, v = half_b * b.orientation.z;
  const auto [s, t] = closest_points(a.position, u, b.position, v);
  return touch_of_balls(a.position + s * u, radius_a, b.position + t * v, radius_b);
}

/// Sphere A against anything.
std::optional<Touch> touch_of_sphere(const PlacedInWorld& a, const PlacedInWorld& b) {
  const double radius = std::get<Sphere>(*a.shape).radius;
  const auto found = sphere_contact(transposed_times(b.orientation, a.position - b.position), radius, *b.shape);
  if (!found) return std::nullopt;
  const Vec3d normal = b.orientation * found->normal;
  return Touch{b.position + b.orientation * found->point - (0.5 * found->depth) * normal, normal, found->depth};
}

}  // namespace

bool can_touch(const Shape& a, const Shape& b) {
  return is_sphere(a) || is_sphere(b) || (std::holds_alternative<Capsule>(a) && std::holds_alternative<Capsule>(b));
}

std::optional<Touch> find_touch(const PlacedInWorld& a, const PlacedInWorld& b) {
  if (is_sphere(*a.shape)) return touch_of_sphere(a, b);
  if (is_sphere(*b.shape)) {
    auto touch = touch_of_sphere(b, a);
    if (touch) touch->normal = -touch->normal;
    return touch;
  }
  return touch_of_capsules(a, b);
}

}  // namespace murosimf::collision
