#include "murosimf/collision/kinematic_separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/collision/ground_finder.h"
#include "murosimf/geometry/collide.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

constexpr double fastest = 1;  // [m/s] of a separation: robots do not jump apart
constexpr double bearable =
    0.15;  // [1] of the thinner one's thickness: tolerated overlap with an entity that can be pushed

/// The deepest overlap so far, reduced by the `bearable` part [m] of each.
class Deepest {
 public:
  void see(const Vec3d& normal, double depth) noexcept {
    if (depth <= depth_) return;
    depth_ = depth;
    normal_ = normal;
  }
  void see(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b,
           double allowed = 0) noexcept {
    geometry::Manifold found;
    if (geometry::collide(a, at_a, b, at_b, found)) see(found, allowed);
  }
  void see(const geometry::Manifold& found, double allowed = 0) noexcept {
    for (int k = 0; k < found.count; ++k) see(found.normal, found.points[k].depth - allowed);
  }

  /// `share` of the horizontal shift [m] that separates A from B, in a step of dt [s]; none if one is on top of the other.
  [[nodiscard]] Vec3d way_out(double share, double dt) const noexcept {
    const double across = std::sqrt(normal_.x * normal_.x + normal_.y * normal_.y);
    MUROSIMF_ASSERT(share >= 0 && dt > 0);
    if (across < 1e-3) return {};
    const double length = std::min(share * depth_ / across, fastest * dt);
    return (length / across) * Vec3d{normal_.x, normal_.y, 0};
  }

 private:
  double depth_ = 0;
  Vec3d normal_;
};

/// Feet are kept apart in the horizontal projection, whatever their height: otherwise one would land on another.
/// `share` of the thinner foot's thickness may overlap.
void see_feet(MovingEntity& a, MovingEntity& b, double share, Deepest& deepest, TestCounts& tests) noexcept {
  for (const int i : a.feet) {
    for (const int j : b.feet) {
      ++tests.objects;
      Transformd lifted = b.pose(j);
      const Transformd foot = a.pose(i);
      lifted.position.z = foot.position.z;
      deepest.see(a.compound.shapes()[i].placed.shape, foot, b.compound.shapes()[j].placed.shape, lifted,
                  share * std::min(a.thickness(i), b.thickness(j)));
    }
  }
}

/// Depth [m] of a contact beyond the tolerated pressure of an entity that cannot be pushed.
double excess_of(const PairContact& c, const std::vector<MovingEntity>& moving_entities) noexcept {
  const double a = moving_entities[c.a].thickness(shape_of_a(c)), b = moving_entities[c.b].thickness(shape_of_b(c));
  return c.depth - bearable * std::min(a, b);
}

/// Thickness [m] of the thinnest shape of a body.
double thinnest(const MovingEntity& entity, int object) noexcept {
  double thickness = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(entity.compound.shapes().size()); ++i) {
    if (entity.compound.shapes()[i].object == object) thickness = std::min(thickness, entity.thickness(i));
  }
  return thickness;
}

/// Largest excess of all contacts of an entity that can be pushed, also with the ground: pressure may press it into a third body.
double strain_of(int pushed, const std::vector<MovingEntity>& moving_entities, const PairSet& set) noexcept {
  MUROSIMF_ASSERT(pushed >= 0 && static_cast<std::size_t>(pushed) < moving_entities.size());
  double most = 0;
  for (const PairContact& c : set.points) {
    if ((c.a == pushed) != (c.b == pushed)) most = std::max(most, excess_of(c, moving_entities));
  }
  const MovingEntity& entity = moving_entities[pushed];
  for (const ContactPoint& c : entity.contacts.points) {
    most = std::max(most, c.depth - bearable * thinnest(entity, c.object));
  }
  return most;
}

/// The contacts of two entities; contacts are sorted by them.
std::span<const PairContact> contacts_of(int a, int b, const std::vector<PairContact>& points) noexcept {
  const auto pair = std::ranges::equal_range(points, std::pair{a, b}, {}, [](const PairContact& c) {
    return std::pair{c.a, c.b};
  });
  return {pair.begin(), pair.end()};
}

/// Whether a shape is a part of uneven ground that can be stood on: no wall.
bool is_slope(const StaticCompound& environment, int shape) noexcept {
  const StaticCompound::Ground* ground = environment.ground_of(shape);
  return ground && (ground->at.orientation * ground->relief->triangles()[shape - ground->first].normal).z >
                       GroundSurface::steepest;
}

void leave(MovingEntity& moving_entity, const StaticCompound& environment, double dt, TestCounts& tests) noexcept {
  if (!moving_entity.is_near_statics(environment, moving_entity.r[0], moving_entity.compound.reach(), tests.volumes)) {
    return;
  }
  moving_entity.refit();
  Deepest deepest;
  tests.volumes += for_pairs(moving_entity.compound, environment.compound(), [&](int i, int j) {
    if (is_slope(environment, j)) return true;
    ++tests.objects;
    const Shape &own = moving_entity.compound.shapes()[i].placed.shape, &other = environment.shape(j).placed.shape;
    geometry::Manifold found;
    const bool meet = geometry::collide(own, moving_entity.pose(i), other, environment.pose(j), found);
    const auto carries = [&] { return found.normal.z >= GroundSurface::steepest; };
    if (meet && !carries()) deepest.see(found);
    return true;
  });
  moving_entity.separation[0] += deepest.way_out(1, dt);
}

}  // namespace

void kinematic_separation(std::vector<MovingEntity>& moving_entities, const StaticCompound& environment,
                          std::span<const std::pair<int, int>> within_reach, double dt, PairSet& set) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  const auto stands_fast = [&](int i) {
    return !moving_entities[i].can_be_pushed() && !moving_entities[i].entity->idle();
  };
  for (MovingEntity& moving_entity : moving_entities) moving_entity.separation[0] = {};
  for (const auto& [a, b] : within_reach) {
    const bool a_fast = stands_fast(a), b_fast = stands_fast(b);
    if (!a_fast && !b_fast) continue;
    MovingEntity &first = moving_entities[a], &second = moving_entities[b];
    if (first.entity->idle() || second.entity->idle()) continue;
    const bool both = a_fast && b_fast;
    Deepest deepest;
    see_feet(first, second, both ? 0 : bearable, deepest, set.tests);
    if (both) {
      for (const PairContact& c : contacts_of(a, b, set.blocked)) deepest.see(c.normal, c.depth);
    } else {
      const auto between = contacts_of(a, b, set.points);
      const auto own_excess = [&](const PairContact& c) { return excess_of(c, moving_entities); };
      if (const auto worst = std::ranges::max_element(between, {}, own_excess); worst != between.end()) {
        deepest.see(worst->normal, std::max(own_excess(*worst), strain_of(a_fast ? b : a, moving_entities, set)));
      }
    }
    if (a_fast) first.separation[0] += deepest.way_out(both ? 0.5 : 1, dt);
    if (b_fast) second.separation[0] -= deepest.way_out(both ? 0.5 : 1, dt);
  }
  for (int i = 0; i < static_cast<int>(moving_entities.size()); ++i) {
    if (stands_fast(i)) leave(moving_entities[i], environment, dt, set.tests);
  }
}

}  // namespace murosimf::collision
