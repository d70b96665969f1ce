#include "murosimf/collision/queries.h"

#include <algorithm>

#include "murosimf/geometry/collide.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {

using geometry::Ray;

QueryScene::Member::Member(const Entity& of, const std::string& volume)
    : entity(&of),
      compound(of.model(), {.volume = volume, .structured = !of.model().joints().empty()}),
      planes(colliding_planes(of.model())) {
  for (const Transformd& pose : rest_poses(of.model())) {
    rest_r.push_back(pose.position);
    rest_R.push_back(pose.orientation);
  }
}

void QueryScene::Member::refresh() noexcept {
  const auto* position = entity->find(properties::position);
  const auto* orientation = entity->find(properties::orientation);
  const bool moves = position && orientation;
  r = moves ? std::span<const Vec3d>(position->values) : rest_r;
  R = moves ? std::span<const Mat3d>(orientation->values) : rest_R;
  stale.store(true, std::memory_order_relaxed);
}

const Compound& QueryScene::Member::fresh() {
  if (stale.load(std::memory_order_acquire)) {
    const std::scoped_lock lock(refitting);
    if (stale.load(std::memory_order_relaxed)) compound.refit(r, R);
    stale.store(false, std::memory_order_release);
  }
  return compound;
}

FoundBy QueryScene::Member::found_by() const {
  if (!entity->present()) return FoundBy::none;
  return planes.empty() ? FoundBy::those_near : FoundBy::all;
}

Transformd QueryScene::Member::pose(const CollidingShape& shape) const {
  return Transformd{r[shape.object], R[shape.object]} * shape.placed.place();
}

QueryScene::QueryScene(const World& world, const std::string& volume) : volume_(volume) {
  members_.reserve(world.entities().size());
  for (const auto& entity : world.entities()) members_.push_back(std::make_unique<Member>(*entity, volume));
}

void QueryScene::add(const Entity& entity) {
  const auto known = [&](const auto& member) { return member->entity == &entity; };
  if (std::ranges::none_of(members_, known)) members_.push_back(std::make_unique<Member>(entity, volume_));
  refresh();
}

void QueryScene::take_back(const Entity& entity) noexcept {
  if (!members_.empty() && members_.back()->entity == &entity) members_.pop_back();
  refresh();
}

void QueryScene::model_exchanged(const Entity& entity) {
  const auto place = std::ranges::find(members_, &entity, [](const auto& member) { return member->entity; });
  if (place == members_.end()) throw SetupError("entity '" + entity.name() + "' is not in the query scene");
  *place = std::make_unique<Member>(entity, volume_);
  refresh();
}

/// The first query after a refresh collects the places of all entities.
void QueryScene::update() noexcept {
  if (!stale_.load(std::memory_order_acquire)) return;
  const std::scoped_lock lock(updating_);
  if (!stale_.load(std::memory_order_relaxed)) return;
  std::vector<geometry::BoundingSphere> reach;
  std::vector<FoundBy> found_by;
  for (const auto& member : members_) {
    member->refresh();
    reach.push_back(member->reach());
    found_by.push_back(member->found_by());
  }
  near_.build(reach, found_by);
  stale_.store(false, std::memory_order_release);
}

QueryScene::Member& QueryScene::member(const Entity* entity) const {
  for (const auto& member : members_) {
    if (member->entity == entity) return *member;
  }
  throw SetupError("entity " + (entity ? "'" + entity->name() + "'" : std::string("(none)")) +
                   " is not in the query scene: make the scene after all entities are added");
}

/// Calls found(hit) for shapes that the ray enters within `range`, which the callee may shorten.
template <class Found>
void QueryScene::for_ray(const Ray& ray, const RayLimits& limits, double& range, const Found& found) {
  const auto reached = [&](const geometry::BoundingSphere& sphere) { return geometry::ray_enters(sphere, ray, range); };
  for_members(reached, [&](Member& member) {
    if (member.entity == limits.without) return;
    const auto test = [&](const CollidingShape& shape) {
      const auto entry = geometry::meet(ray, shape.placed.shape, member.pose(shape));
      if (!entry || !(entry->distance <= range)) return;
      found(RayHit{{member.entity, shape.object},
                   shape.index,
                   entry->distance,
                   ray.origin + entry->distance * ray.direction,
                   entry->normal});
    };
    for (const CollidingShape& plane : member.planes) test(plane);
    if (!reached(member.reach())) return;
    const auto wanted = [&](const auto& volume) { return geometry::ray_enters(volume, ray, range); };
    const auto visit = [&](int leaf) {
      test(member.compound.shapes()[leaf]);
      return true;
    };
    std::visit([&](const auto& tree) { geometry::for_leaves(tree, wanted, visit); }, member.fresh().tree());
  });
}

std::optional<RayHit> QueryScene::cast(const Ray& ray, const RayLimits& limits) {
  std::optional<RayHit> first;
  double range = limits.range;
  for_ray(ray, limits, range, [&](const RayHit& hit) {
    if (first && hit.distance >= first->distance) return;
    first = hit;
    range = hit.distance;
  });
  return first;
}

std::vector<RayHit> QueryScene::cast_all(const Ray& ray, const RayLimits& limits) {
  std::vector<RayHit> hits;
  double range = limits.range;
  for_ray(ray, limits, range, [&](const RayHit& hit) { hits.push_back(hit); });
  std::stable_sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) { return a.distance < b.distance; });
  return hits;
}

std::vector<BodyRef> QueryScene::overlapping(const Shape& shape, const Transformd& at) {
  std::vector<BodyRef> bodies;
  const bool endless = std::holds_alternative<Plane>(shape);
  const auto around = endless ? geometry::BoundingSphere{at.position, std::numeric_limits<double>::infinity()}
                              : geometry::fit<geometry::BoundingSphere>(shape, at);
  const auto near = [&](const geometry::BoundingSphere& sphere) { return overlap(around, sphere); };
  for_members(near, [&](Member& member) {
    std::vector<int> objects;
    const auto test = [&](const CollidingShape& other) {
      geometry::Manifold found;
      if (geometry::collide(shape, at, other.placed.shape, member.pose(other), found)) objects.push_back(other.object);
      return true;
    };
    for (const CollidingShape& plane : member.planes) test(plane);
    if (near(member.reach())) {
      const auto wanted = [&](const auto& volume) { return overlap(around, volume); };
      const auto visit = [&](int leaf) { return test(member.compound.shapes()[leaf]); };
      std::visit([&](const auto& tree) { geometry::for_leaves(tree, wanted, visit); }, member.fresh().tree());
    }
    std::sort(objects.begin(), objects.end());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    for (const int object : objects) bodies.push_back({member.entity, object});
  });
  return bodies;
}

/// The nearest two shapes of bodies `a` and `b`, of the members `first` and `second`.
struct QueryScene::NearestSearch {
  const BodyRef &a, &b;
  const Member &first, &second;
  static constexpr double touching = 1e-9;  // [m]
  double least = std::numeric_limits<double>::infinity();
  std::optional<Separation> best;

  static bool belongs(const BodyRef& body, const CollidingShape& shape) {
    return body.object == BodyRef::all || body.object == shape.object;
  }
  /// Returns the distance, but never less than `touching`: so all pairs whose volumes overlap are looked at.
  double see(const CollidingShape& shape_a, const CollidingShape& shape_b) {
    if (!belongs(a, shape_a) || !belongs(b, shape_b)) return std::numeric_limits<double>::infinity();
    const geometry::Gap found =
        geometry::distance(shape_a.placed.shape, first.pose(shape_a), shape_b.placed.shape, second.pose(shape_b));
    if (found.distance < least) {
      best = Separation{found, {a.entity, shape_a.object}, {b.entity, shape_b.object}};
      least = found.distance;
    }
    return std::max(found.distance, touching);
  }
  void see_planes() {
    for (const CollidingShape& plane : first.planes) {
      for (const CollidingShape& shape : second.compound.shapes()) see(plane, shape);
    }
    for (const CollidingShape& plane : second.planes) {
      for (const CollidingShape& shape : first.compound.shapes()) see(shape, plane);
    }
  }
};

std::optional<Separation> QueryScene::distance(const BodyRef& a, const BodyRef& b) {
  update();
  Member &first = member(a.entity), &second = member(b.entity);
  if (!a.entity->present() || !b.entity->present()) return {};
  NearestSearch search{a, b, first, second, std::numeric_limits<double>::infinity(), {}};
  search.see_planes();
  const auto through = [&](const auto& tree_a, const auto& tree_b) {
    const auto see = [&](int i, int j) { return search.see(first.compound.shapes()[i], second.compound.shapes()[j]); };
    geometry::nearest_pair(tree_a, tree_b, std::max(search.least, NearestSearch::touching), see);
  };
  std::visit(through, first.fresh().tree(), second.fresh().tree());
  return search.best;
}

}  // namespace murosimf::collision
