#include "murosimf/collision/body_pairs.h"

#include <algorithm>

#include "murosimf/geometry/collide.h"

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

}  // namespace

bool can_touch(const Shape& a, const Shape& b) {
  return is_sphere(a) || is_sphere(b) || (std::holds_alternative<Capsule>(a) && std::holds_alternative<Capsule>(b));
}

std::optional<Touch> find_touch(const PlacedInWorld& a, const PlacedInWorld& b) {
  geometry::Manifold found;
  if (!geometry::collide(*a.shape, {a.position, a.orientation}, *b.shape, {b.position, b.orientation}, found))
    return {};
  const auto deepest = std::max_element(found.points.begin(), found.points.begin() + found.count,
                                        [](const auto& p, const auto& q) { return p.depth < q.depth; });
  return Touch{deepest->point, found.normal, deepest->depth};
}

}  // namespace murosimf::collision
