#include "murosimf/collision/keep_apart.h"

#include <algorithm>
#include <cmath>

#include "murosimf/geometry/collide.h"

namespace murosimf::collision {
namespace {

constexpr double longest_way = 1e-3;  // [m] in one step

/// The deepest overlap that has been seen.
class Deepest {
 public:
  void see(const Shape& a, const geometry::Pose& at_a, const Shape& b, const geometry::Pose& at_b) noexcept {
    geometry::Manifold found;
    if (!geometry::collide(a, at_a, b, at_b, found)) return;
    for (int k = 0; k < found.count; ++k) {
      if (found.points[k].depth > depth_) {
        depth_ = found.points[k].depth;
        normal_ = found.normal;
      }
    }
  }

  /// Way [m] along the ground that takes A out of B; one on top of the other is not helped.
  [[nodiscard]] Vec3d way_out() const noexcept {
    const double across = std::hypot(normal_.x, normal_.y);
    if (across < 1e-3) return {};
    return (depth_ / across) * Vec3d{normal_.x, normal_.y, 0};
  }

 private:
  double depth_ = 0;
  Vec3d normal_;
};

Vec3d part_of(double share, const Vec3d& way) {
  const double length = share * norm(way);
  return length > longest_way ? (share * longest_way / length) * way : share * way;
}

/// Feet are held apart as seen from above, whatever their height: else one would come down on another.
void see_feet(const Mover& a, const Mover& b, Deepest& deepest, TestCounts& tests) noexcept {
  for (const int i : a.feet) {
    for (const int j : b.feet) {
      ++tests.objects;
      geometry::Pose lifted = b.pose(j);
      const geometry::Pose foot = a.pose(i);
      lifted.position.z = foot.position.z;
      deepest.see(a.compound.shapes()[i].placed.shape, foot, b.compound.shapes()[j].placed.shape, lifted);
    }
  }
}

void part(Mover& a, Mover& b, TestCounts& tests) noexcept {
  ++tests.volumes;
  if (!a.is_near(b)) return;
  a.refit();
  b.refit();
  Deepest deepest;
  see_feet(a, b, deepest, tests);
  tests.volumes += for_pairs(a.compound, b.compound, [&](int i, int j) {
    ++tests.objects;
    deepest.see(a.compound.shapes()[i].placed.shape, a.pose(i), b.compound.shapes()[j].placed.shape, b.pose(j));
    return true;
  });
  const Vec3d half = part_of(0.5, deepest.way_out());
  a.separation[0] += half;
  b.separation[0] -= half;
}

void leave(Mover& mover, const StaticCompound& environment, TestCounts& tests) noexcept {
  if (!environment.is_near(mover.r[0], mover.compound.reach(), tests.volumes)) return;
  mover.refit();
  Deepest deepest;
  tests.volumes += for_pairs(mover.compound, environment.compound(), [&](int i, int j) {
    ++tests.objects;
    const CollidingShape &own = mover.compound.shapes()[i], &other = environment.shape(j);
    deepest.see(own.placed.shape, mover.pose(i), other.placed.shape, environment.pose(j));
    return true;
  });
  mover.separation[0] += part_of(1, deepest.way_out());
}

}  // namespace

void keep_apart(std::vector<Mover>& movers, const StaticCompound& environment, TestCounts& tests) noexcept {
  const auto stands_fast = [](const Mover& mover) { return !mover.can_be_pushed() && !mover.entity->frozen(); };
  for (Mover& mover : movers) mover.separation[0] = {};
  for (std::size_t a = 0; a < movers.size(); ++a) {
    if (!stands_fast(movers[a])) continue;
    for (std::size_t b = a + 1; b < movers.size(); ++b) {
      if (stands_fast(movers[b])) part(movers[a], movers[b], tests);
    }
    leave(movers[a], environment, tests);
  }
}

}  // namespace murosimf::collision
