#include "murosimf/collision/static_touch.h"

#include <algorithm>

#include "murosimf/geometry/collide.h"

namespace murosimf::collision {
namespace {

constexpr std::uint64_t features_of_pair = std::uint64_t{1} << 32;

double round_radius(const Shape& shape) {
  const Sphere* sphere = std::get_if<Sphere>(&shape);
  return sphere ? sphere->radius : 0;
}

void sort_by_feature(geometry::Manifold& manifold) {
  std::sort(manifold.points.begin(), manifold.points.begin() + manifold.count,
            [](const auto& a, const auto& b) { return a.feature < b.feature; });
}

}  // namespace

StaticTouch::StaticTouch(const Entity& entity, const Entity* environment)
    : own_(entity.model(), {.volume = entity.options().collision.volume}), environment_(environment) {}

void StaticTouch::find(std::span<const Vec3d> r, std::span<const Mat3d> R, std::uint64_t first_feature,
                       std::uint32_t first_surface, std::vector<ContactPoint>& found, TestCounts& tests) noexcept {
  if (!environment_.is_near(r[0], own_.reach(), tests.volumes)) return;
  own_.refit(r, R);
  candidates_.clear();
  tests.volumes += for_pairs(environment_.compound(), own_, [&](int j, int i) {
    candidates_.emplace_back(j, i);
    return true;
  });
  std::sort(candidates_.begin(), candidates_.end());
  geometry::Manifold manifold;
  for (const auto& [j, i] : candidates_) {
    const CollidingShape& shape = own_.shapes()[i];
    ++tests.objects;
    const Shape& other = environment_.shape(j).placed.shape;
    if (!geometry::collide(shape.placed.shape, own_.pose(i, r, R), other, environment_.pose(j), manifold)) continue;
    sort_by_feature(manifold);
    const auto pair = static_cast<std::uint32_t>(j * static_cast<int>(own_.shapes().size()) + i);
    for (int k = 0; k < manifold.count; ++k) {
      ContactPoint& c = found.emplace_back();
      c.object = shape.object;
      c.feature = first_feature + pair * features_of_pair + manifold.points[k].feature;
      c.surface = first_surface + pair;
      c.point = manifold.points[k].point;
      c.normal = manifold.normal;
      c.depth = manifold.points[k].depth;
      c.radius = round_radius(shape.placed.shape);
    }
  }
}

}  // namespace murosimf::collision
