#include "murosimf/collision/kinematic_separation.h"

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
  void see(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) noexcept {
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
void see_feet(MovingEntity& a, MovingEntity& b, Deepest& deepest, TestCounts& tests) noexcept {
  for (const int i : a.feet) {
    for (const int j : b.feet) {
      ++tests.objects;
      Transformd lifted = b.pose(j);
      const Transformd foot = a.pose(i);
      lifted.position.z = foot.position.z;
      deepest.see(a.compound.shapes()[i].placed.shape, foot, b.compound.shapes()[j].placed.shape, lifted);
    }
  }
}

void leave(MovingEntity& moving_entity, const StaticCompound& environment, TestCounts& tests) noexcept {
  if (!moving_entity.is_near_statics(environment, moving_entity.r[0], moving_entity.compound.reach(), tests.volumes)) {
    return;
  }
  moving_entity.refit();
  Deepest deepest;
  tests.volumes += for_pairs(moving_entity.compound, environment.compound(), [&](int i, int j) {
    ++tests.objects;
    const Shape &own = moving_entity.compound.shapes()[i].placed.shape, &other = environment.shape(j).placed.shape;
    deepest.see(own, moving_entity.pose(i), other, environment.pose(j));
    return true;
  });
  moving_entity.separation[0] += deepest.way_out(1);
}

}  // namespace

void kinematic_separation(std::vector<MovingEntity>& moving_entities, const StaticCompound& environment,
                          std::span<const std::pair<int, int>> within_reach, PairSet& set) noexcept {
  const auto stands_fast = [&](int i) {
    return !moving_entities[i].can_be_pushed() && !moving_entities[i].entity->idle();
  };
  for (MovingEntity& moving_entity : moving_entities) moving_entity.separation[0] = {};
  auto contact = set.blocked.begin();  // they come in the order of these loops
  auto pair = within_reach.begin();
  for (int a = 0; a < static_cast<int>(moving_entities.size()); ++a) {
    const bool fast = stands_fast(a);
    for (; pair != within_reach.end() && pair->first == a; ++pair) {
      const int b = pair->second;
      if (!fast || !stands_fast(b)) continue;
      Deepest deepest;
      see_feet(moving_entities[a], moving_entities[b], deepest, set.tests);
      for (; contact != set.blocked.end() && contact->a == a && contact->b == b; ++contact) {
        deepest.see(contact->normal, contact->depth);
      }
      moving_entities[a].separation[0] += deepest.way_out(0.5);
      moving_entities[b].separation[0] -= deepest.way_out(0.5);
    }
    if (fast) leave(moving_entities[a], environment, set.tests);
  }
}

}  // namespace murosimf::collision
