#include "murosimf/collision/pair_finder.h"

#include <algorithm>

#include "murosimf/collision/contact_laws/depenetration.h"
#include "murosimf/collision/surface_kinds.h"
#include "murosimf/geometry/four_points.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

constexpr double fastest_walker = 3.0;  // [m/s] limit of the velocity of a kinematic entity's points

bool comes_before(const PairContact& a, const PairContact& b) {
  return a.shapes != b.shapes ? a.shapes < b.shapes : a.feature < b.feature;
}

/// A kinematic robot may change its standing foot within a step: the jump of velocity must not accelerate the ball.
Vec3d velocity_that_counts(const MovingEntity& moving_entity, int object, const Vec3d& arm) {
  const Vec3d v = moving_entity.velocity_at(object, arm);
  const double speed = norm(v);
  return moving_entity.can_be_pushed() || speed <= fastest_walker ? v : (fastest_walker / speed) * v;
}

/// Bodies that have touched already were not placed into each other: this new point is resolved as fast as the others.
void begin_lift(PairContact& point, const std::vector<PairContact>& previous, double dt) {
  const auto same_bodies = [&](const PairContact& other) {
    return other.a == point.a && other.b == point.b && other.object == point.object && other.object_b == point.object_b;
  };
  const auto other = std::find_if(previous.begin(), previous.end(), same_bodies);
  if (other == previous.end()) return begin_depenetration(point, dt);
  point.lift = other->lift;
}

/// Relative acceleration [m/s^2] of A against B due to gravity: an entity that stands on something does not fall.
Vec3d falls_with(const MovingEntity& a, const MovingEntity& b, const Vec3d& gravity) {
  const double stands_a = a.contacts.points.empty() ? 0 : 1, stands_b = b.contacts.points.empty() ? 0 : 1;
  return (stands_b - stands_a) * gravity;
}

void remember(const std::vector<MovingEntity>& moving_entities, PairSet& set, const Vec3d& gravity, double dt) {
  auto old = set.previous.begin();
  // both lists are sorted: one pass finds the memory of each point
  for (PairContact& c : set.points) {
    while (old != set.previous.end() && comes_before(*old, c)) ++old;
    if (old == set.previous.end() || comes_before(c, *old)) {
      begin_lift(c, set.previous, dt);
      begin_bounce(c, set.parameters[c.surface], falls_with(moving_entities[c.a], moving_entities[c.b], gravity), dt);
    } else {
      recall(*old, c);
      go_on_bouncing(c);
    }
  }
}

}  // namespace

PairFinder::PairFinder(const MaterialTable& materials, const ContactConditions& conditions, const Vec3d& gravity)
    : materials_(materials), conditions_(conditions), gravity_(gravity) {}

void PairFinder::add(const MovingEntity& moving_entity) {
  limbs_.emplace_back();
  add_kinds(moving_entity);
}

void PairFinder::add_kinds(const MovingEntity& moving_entity) {
  auto& kinds = kinds_of_shapes_.emplace_back();
  for (const CollidingShape& shape : moving_entity.compound.shapes())
    kinds.push_back(kind_of(moving_entity.model(), shape.placed.surface));
}

void PairFinder::take_back() noexcept {
  MUROSIMF_ASSERT(!limbs_.empty() && limbs_.size() == kinds_of_shapes_.size());
  limbs_.pop_back();
  kinds_of_shapes_.pop_back();
  std::size_t used = 0;
  for (const auto& kinds : kinds_of_shapes_) {
    for (const std::size_t kind : kinds) used = std::max(used, kind + 1);
  }
  kinds_.erase(kinds_.begin() + static_cast<std::ptrdiff_t>(used), kinds_.end());
}

void PairFinder::model_exchanged(const std::vector<MovingEntity>& moving_entities, const Entity& entity, PairSet& set) {
  kinds_.clear();
  kinds_of_shapes_.clear();
  for (const MovingEntity& moving_entity : moving_entities) add_kinds(moving_entity);
  forget_neighbors();
  const auto is_of_it = [&](const PairContact& c) {
    return moving_entities[c.a].entity == &entity || moving_entities[c.b].entity == &entity;
  };
  for (auto* points : {&set.points, &set.blocked}) std::erase_if(*points, is_of_it);
  number_surfaces(set);
}

void PairFinder::number_surfaces(PairSet& set) const noexcept {
  for (auto* points : {&set.points, &set.blocked}) {
    for (PairContact& c : *points) c.surface = surface_of(c.a, c.b, shape_of_a(c), shape_of_b(c));
  }
}

std::uint32_t PairFinder::surface_of(int a, int b, int shape_a, int shape_b) const noexcept {
  MUROSIMF_ASSERT(static_cast<std::size_t>(a) < kinds_of_shapes_.size() &&
                  static_cast<std::size_t>(b) < kinds_of_shapes_.size());
  return static_cast<std::uint32_t>(kinds_of_shapes_[a][shape_a] * kinds_.size() + kinds_of_shapes_[b][shape_b]);
}

std::vector<ContactParameters> PairFinder::parameters() const {
  std::vector<ContactParameters> parameters;
  for (const Kind& a : kinds_) {
    for (const Kind& b : kinds_) {
      parameters.push_back(contact_parameters(*a.model, *b.model, materials_.find(a.surface, b.surface), conditions_));
    }
  }
  return parameters;
}

std::size_t PairFinder::kind_of(const Model& model, const Surface& surface) {
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    if (kinds_[i].model == &model && are_alike(kinds_[i].surface, surface)) return i;
  }
  kinds_.push_back({&model, surface});
  return kinds_.size() - 1;
}

void PairFinder::find(std::vector<MovingEntity>& moving_entities, PairSet& set) noexcept {
  MUROSIMF_ASSERT(limbs_.size() == moving_entities.size());
  set.previous.swap(set.points);
  set.points.clear();
  set.blocked.clear();
  set.tests = {};
  reach_.clear();
  for (const MovingEntity& moving_entity : moving_entities) reach_.push_back(moving_entity.reach());
  sweep_.find(reach_);
  set.tests.volumes += sweep_.tests();
  renew_neighbors();
  std::size_t pair = 0;
  // entities and pairs in order: the order of contacts, and so the sums of forces, are the same in every run
  for (int a = 0; a < static_cast<int>(moving_entities.size()); ++a) {
    const bool out = moving_entities[a].apart();
    if (!out && moving_entities[a].limbs_can_touch()) find_between(moving_entities, a, a, limbs_[a], set);
    for (; pair < pairs_.size() && pairs_[pair].first == a; ++pair) {
      const int b = pairs_[pair].second;
      if (!out && !moving_entities[b].apart()) find_between(moving_entities, a, b, neighbors_[pair], set);
    }
  }
  remember(moving_entities, set, gravity_, conditions_.dt);
}

void PairFinder::forget_neighbors() noexcept {
  for (auto* all : {&neighbors_, &limbs_}) {
    for (Neighbors& near : *all) near.fits_a = near.fits_b = 0;
  }
}

/// Keeps the cached shapes of pairs that are still within reach; these are usually the pairs of the preceding step.
void PairFinder::renew_neighbors() {
  const auto& next = sweep_.pairs();
  if (next == pairs_) return;
  old_.swap(neighbors_);
  neighbors_.clear();
  std::size_t before = 0;
  for (const auto& pair : next) {
    while (before < pairs_.size() && pairs_[before] < pair) ++before;
    const bool known = before < pairs_.size() && pairs_[before] == pair;
    neighbors_.push_back(known ? std::move(old_[before]) : Neighbors{});
  }
  MUROSIMF_ASSERT(before <= pairs_.size());
  pairs_ = next;
}

void PairFinder::find_between(std::vector<MovingEntity>& moving_entities, int a, int b, Neighbors& near,
                              PairSet& set) noexcept {
  MovingEntity &first = moving_entities[a], &second = moving_entities[b];
  first.refit();
  second.refit();
  if (near.fits_a != first.fits() || near.fits_b != second.fits()) {
    near.fits_a = first.fits();
    near.fits_b = second.fits();
    near.shapes.clear();
    const auto add = [&](int i, int j) {
      near.shapes.emplace_back(i, j);
      return true;
    };
    set.tests.volumes +=
        a == b ? for_inner_pairs(first.compound, add) : for_pairs(first.compound, second.compound, add);
    std::sort(near.shapes.begin(), near.shapes.end());
  }
  MUROSIMF_ASSERT(near.fits_a == first.fits() && near.fits_b == second.fits());
  test(moving_entities, a, b, near.shapes, set);
}

void PairFinder::test(std::vector<MovingEntity>& moving_entities, int a, int b,
                      const std::vector<std::pair<int, int>>& shapes, PairSet& set) noexcept {
  MovingEntity &first = moving_entities[a], &second = moving_entities[b];
  PairContact pair;
  pair.a = a;
  pair.b = b;
  geometry::Manifold manifold;
  int of = -1;  // the shape of the first entity that `sphere` belongs to
  geometry::BoundingSphere sphere;
  for (const auto& [i, j] : shapes) {
    ++set.tests.volumes;
    if (i != of) sphere = first.sphere(i);
    of = i;
    if (!overlap(sphere, second.sphere(j))) continue;
    ++set.tests.objects;
    const CollidingShape &shape_a = first.compound.shapes()[i], &shape_b = second.compound.shapes()[j];
    if (!geometry::collide(shape_a.placed.shape, first.pose(i), shape_b.placed.shape, second.pose(j), manifold)) {
      continue;
    }
    pair.object = shape_a.object;
    pair.object_b = shape_b.object;
    pair.shapes = number_of_shapes(a, b, i, j);
    pair.surface = surface_of(a, b, i, j);
    add_contacts(moving_entities, pair, manifold, set);
  }
}

void PairFinder::add_contacts(const std::vector<MovingEntity>& moving_entities, const PairContact& pair,
                              geometry::Manifold& manifold, PairSet& set) const noexcept {
  const MovingEntity &first = moving_entities[pair.a], &second = moving_entities[pair.b];
  const bool pushes = first.can_be_pushed() || second.can_be_pushed();
  std::vector<PairContact>& points = pushes ? set.points : set.blocked;
  sort_by_feature(manifold);
  keep_four(manifold);  // four corners hold a body: more points only cost time
  for (int k = 0; k < manifold.count; ++k) {
    const geometry::ManifoldPoint& found = manifold.points[k];
    PairContact& c = points.emplace_back(pair);
    c.feature = found.feature;
    c.point = found.point;
    c.normal = manifold.normal;
    c.depth = found.depth;
    c.arm_a = c.point - first.r[c.object];
    c.arm_b = c.point - second.r[c.object_b];
    c.velocity_a = velocity_that_counts(first, c.object, c.arm_a);
    c.velocity_b = velocity_that_counts(second, c.object_b, c.arm_b);
    c.velocity = c.velocity_a - c.velocity_b;
  }
}

}  // namespace murosimf::collision
