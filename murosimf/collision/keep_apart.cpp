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
  void see(const Vec3d& normal, double depth) noexcept {
    if (depth <= depth_) return;
    depth_ = depth;
    normal_ = normal;
  }
  void see(const Shape& a, const geometry::Pose& at_a, const Shape& b, const geometry::Pose& at_b) noexcept {
    geometry::Manifold found;
    if (!geometry::collide(a, at_a, b, at_b, found)) return;
    for (int k = 0; k < found.count; ++k) see(found.normal, found.points[k].depth);
  }

  /// `share` of the way [m] along the ground that takes A out of B; one on top of the other is not helped.
  [[nodiscard]] Vec3d way_out(double share) const noexcept {
    const double across = std::sqrt(normal_.x * normal_.x + normal_.y * normal_.y);
    if (across < 1e-3) return {};
    const double length = std::min(share * depth_ / across, longest_way);
    return (length / across) * Vec3d{normal_.x, normal_.y, 0};
  }

 private:
  double depth_ = 0;
  Vec3d normal_;
};

/// Feet are held apart as seen from above, whatever their height: else one would come down on another.
void see_feet(Mover& a, Mover& b, Deepest& deepest, TestCounts& tests) noexcept {
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

void leave(Mover& mover, const StaticCompound& environment, TestCounts& tests) noexcept {
  if (!environment.is_near(mover.r[0], mover.compound.reach(), tests.volumes)) return;
  mover.refit();
  Deepest deepest;
  tests.volumes += for_pairs(mover.compound, environment.compound(), [&](int i, int j) {
    ++tests.objects;
    const Shape &own = mover.compound.shapes()[i].placed.shape, &other = environment.shape(j).placed.shape;
    deepest.see(own, mover.pose(i), other, environment.pose(j));
    return true;
  });
  mover.separation[0] += deepest.way_out(1);
}

}  // namespace

void keep_apart(std::vector<Mover>& movers, const StaticCompound& environment, PairSet& set) noexcept {
  const auto stands_fast = [](const Mover& mover) { return !mover.can_be_pushed() && !mover.entity->frozen(); };
  for (Mover& mover : movers) mover.separation[0] = {};
  auto contact = set.blocked.begin();  // they come in the order of these loops
  for (int a = 0; a < static_cast<int>(movers.size()); ++a) {
    if (!stands_fast(movers[a])) continue;
    for (int b = a + 1; b < static_cast<int>(movers.size()); ++b) {
      if (!stands_fast(movers[b]) || !overlap(movers[a].reach(), movers[b].reach())) continue;
      Deepest deepest;
      see_feet(movers[a], movers[b], deepest, set.tests);
      for (; contact != set.blocked.end() && contact->a == a && contact->b == b; ++contact) {
        deepest.see(contact->normal, contact->depth);
      }
      movers[a].separation[0] += deepest.way_out(0.5);
      movers[b].separation[0] -= deepest.way_out(0.5);
    }
    leave(movers[a], environment, set.tests);
  }
}

}  // namespace murosimf::collision
