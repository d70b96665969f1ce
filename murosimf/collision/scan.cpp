#include "murosimf/collision/scan.h"

#include "murosimf/collision/queries.h"

namespace murosimf::collision {

namespace {

/// How much more than they should be spheres [m] and sectors [rad] are, so that rounding loses no ray.
constexpr double slack = 1e-6;

}  // namespace

Fan::Fan(int rays, double first, double fov)
    : first_(first), step_(rays > 1 ? fov / static_cast<double>(rays - 1) : 0) {
  directions_.reserve(static_cast<std::size_t>(rays));
  for (int i = 0; i < rays; ++i) {
    const double angle = first + static_cast<double>(i) * step_;
    directions_.push_back({std::cos(angle), std::sin(angle), 0});
  }
}

Fan::Sector Fan::sector(const geometry::BoundingSphere& sphere) const {
  const Vec3d& c = sphere.center;
  const double disc = sqrt(std::max(sphere.radius * sphere.radius - c.z * c.z, 0.0));
  const double away = std::hypot(c.x, c.y);
  if (away <= disc + slack) return {};
  const double bearing = std::atan2(c.y, c.x) - first_;
  return {bearing - 2 * pi * std::floor(bearing / (2 * pi)), std::asin(disc / away) + slack};
}

/// One scan that is being made.
struct QueryScene::FanCast {
  const Fan& fan;
  const Transformd& at;
  double range;  // [m]
  std::span<double> distances;

  [[nodiscard]] geometry::BoundingSphere in_fan(const geometry::BoundingSphere& sphere) const {
    return {transposed_times(at.orientation, sphere.center - at.position), sphere.radius + slack};
  }
  /// The fan's plane cuts the volume, and not too far away.
  template <class V>
  [[nodiscard]] bool wants(const V& volume) const {
    const auto sphere = in_fan(geometry::sphere_around(volume));
    const double limit = range + sphere.radius;
    return abs(sphere.center.z) <= sphere.radius && dot(sphere.center, sphere.center) <= limit * limit;
  }
  void meet(std::size_t i, const Shape& shape, const Transformd& place) const {
    const auto entry = geometry::meet(fan.ray(i, at), shape, place);
    if (entry && entry->distance <= range) distances[i] = std::min(distances[i], entry->distance);
  }
  /// From above, only rays count that come down to the plane before they meet something else.
  void see_plane(const Shape& plane, const Transformd& place) const {
    const Vec3d up = transposed_times(at.orientation, place.orientation.z);
    const double height = dot(place.orientation.z, at.position - place.position) - slack;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const double limit = std::min(range, distances[i]);
      if (height <= 0 || !(height + dot(up, fan.direction(i)) * limit > 0)) meet(i, plane, place);
    }
  }
  void see(const Shape& shape, const Transformd& place, const geometry::BoundingSphere& around) const {
    const auto sphere = in_fan(around);
    const double nearest = norm(sphere.center) - sphere.radius;
    fan.for_rays_towards(sphere, [&](std::size_t i) {
      if (nearest < distances[i]) meet(i, shape, place);
    });
  }
  void see_planes(const Member& member) const {
    for (const CollidingShape& plane : member.planes) see_plane(plane.placed.shape, member.pose(plane));
  }
  void see(Member& member) const {
    if (!wants(member.reach())) return;
    const auto through = [&](const auto& tree) {
      const auto visit = [&](int leaf) {
        const CollidingShape& shape = member.compound.shapes()[leaf];
        see(shape.placed.shape, member.pose(shape), geometry::sphere_around(tree.leaf_volume(leaf)));
        return true;
      };
      geometry::for_leaves(
          tree, [&](const auto& volume) { return wants(volume); }, visit);
    };
    std::visit(through, member.fresh().tree());
  }
};

void QueryScene::cast(const Fan& fan, const Transformd& at, const RayLimits& limits,
                      std::span<double> distances) noexcept {
  std::fill(distances.begin(), distances.end(), std::numeric_limits<double>::infinity());
  const FanCast cast{fan, at, limits.range, distances};
  const auto wanted = [&](const geometry::BoundingSphere& sphere) { return cast.wants(sphere); };
  for_members(wanted, [&](Member& member) {
    if (member.entity != limits.without) cast.see(member);
  });
  for (const auto& member : members_) {  // last: what is nearer spares the rays
    if (member->entity != limits.without) cast.see_planes(*member);
  }
}

}  // namespace murosimf::collision
