#include "murosimf/collision/keep_apart.h"

#include <algorithm>
#include <cmath>

#include "murosimf/geometry/collide.h"

namespace murosimf::collision {
namespace {

constexpr double longest_way = 1e-3;  // [m] in one step

/// Way [m] along the ground that takes A out of B; one on top of the other is not helped.
Vec3d way_out(const Vec3d& normal, double depth) {
  const double across = std::sqrt(normal.x * normal.x + normal.y * normal.y);
  if (across < 1e-3) return {};
  return (depth / across) * Vec3d{normal.x, normal.y, 0};
}

Vec3d part_of(double share, const Vec3d& way) {
  const double length = share * norm(way);
  return length > longest_way ? (share * longest_way / length) * way : share * way;
}

/// Half of the way out for either, by the deepest of the points from `first` on that belong to the same two.
std::size_t part(std::vector<Mover>& movers, const std::vector<PairContact>& points, std::size_t first) noexcept {
  std::size_t deepest = first, i = first;
  for (; i < points.size() && points[i].a == points[first].a && points[i].b == points[first].b; ++i) {
    if (points[i].depth > points[deepest].depth) deepest = i;
  }
  const PairContact& c = points[deepest];
  const Vec3d half = part_of(0.5, way_out(c.normal, c.depth));
  movers[c.a].separation[0] += half;
  movers[c.b].separation[0] -= half;
  return i;
}

void leave(Mover& mover, const StaticCompound& environment, TestCounts& tests) noexcept {
  if (!environment.is_near(mover.r[0], mover.compound.reach(), tests.volumes)) return;
  mover.refit();
  geometry::Manifold found;
  geometry::ManifoldPoint deepest;
  Vec3d normal;
  tests.volumes += for_pairs(mover.compound, environment.compound(), [&](int i, int j) {
    ++tests.objects;
    const Shape &own = mover.compound.shapes()[i].placed.shape, &other = environment.shape(j).placed.shape;
    if (!geometry::collide(own, mover.pose(i), other, environment.pose(j), found)) return true;
    for (int k = 0; k < found.count; ++k) {
      if (found.points[k].depth <= deepest.depth) continue;
      deepest = found.points[k];
      normal = found.normal;
    }
    return true;
  });
  mover.separation[0] += part_of(1, way_out(normal, deepest.depth));
}

}  // namespace

void keep_apart(std::vector<Mover>& movers, const StaticCompound& environment, PairSet& set) noexcept {
  for (Mover& mover : movers) mover.separation[0] = {};
  for (std::size_t i = 0; i < set.blocked.size();) i = part(movers, set.blocked, i);
  for (Mover& mover : movers) {
    if (!mover.can_be_pushed() && !mover.entity->frozen()) leave(mover, environment, set.tests);
  }
}

}  // namespace murosimf::collision
