/// queries.h - questions about where bodies are: rays, distances and overlaps, for users and sensors.
///
/// Entities are found by a tree of their spheres of reach (entity_tree.h), then the trees of those that a question comes
/// near are worked out, once after each refresh, at the first query. Several threads may query at the same time.
///
///     QueryScene scene(world);
///     scene.refresh();  // after every step
///     if (const auto hit = scene.cast({eye, forward}, {.without = &robot})) ...
#pragma once

#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/collision/compound.h"
#include "murosimf/collision/entity_tree.h"
#include "murosimf/geometry/distance.h"
#include "murosimf/world/world.h"

namespace murosimf::collision {

class Fan;

/// A body of an entity, or all of them.
struct BodyRef {
  static constexpr int all = -1;

  const Entity* entity = nullptr;
  int object = all;

  friend bool operator==(const BodyRef&, const BodyRef&) = default;
};

struct RayHit {
  BodyRef body;
  int shape = 0;        ///< which of the object's shapes
  double distance = 0;  ///< [m] from the ray's origin
  Vec3d point;          ///< [m] world frame
  Vec3d normal;         ///< [1] of the surface, unit, outwards, world frame; see geometry::meet for rays from inside
};

struct RayLimits {
  double range = std::numeric_limits<double>::infinity();  ///< [m]
  const Entity* without = nullptr;                         ///< the robot that carries the sensor
};

/// The nearest points of two bodies; of bodies that overlap, where they do deepest (geometry/distance.h).
struct Separation : geometry::Gap {
  BodyRef a, b;  ///< which bodies these are; of several that are equally near, any
};

/// All shapes of a world's entities that collide, planes too; of those that are there (Entity::present). Entities whose level keeps poses are where their columns
/// say, others where their model puts them. Answers do not depend on `volume`, only their cost does.
class QueryScene {
 public:
  /// Of the entities that the world has now; it must outlive the scene. Throws SetupError if there is no such volume.
  explicit QueryScene(const World& world, const std::string& volume = "sphere");

  /// One that the world got later; nothing, if it is there already. No queries meanwhile. Throws SetupError as the constructor.
  void add(const Entity& entity);
  /// Forgets one again that is the last of all; nothing, if it is not.
  void take_back(const Entity& entity) noexcept;

  /// One has another model of the same objects; spans of its shapes end. Throws SetupError if it is not in the scene.
  void model_exchanged(const Entity& entity);

  /// To be called after something has moved, while no query runs; the work is done when a query comes near an entity.
  void refresh() noexcept { stale_.store(true, std::memory_order_release); }

  /// Shapes of an entity that collide, without planes; in the order of colliding_shapes(). Throws SetupError if it is not
  /// in the scene.
  [[nodiscard]] std::span<const CollidingShape> shapes(const Entity& entity) const {
    return member(&entity).compound.shapes();
  }

  /// The first shape on a ray; at the same distance, of the entity that was added first.
  [[nodiscard]] std::optional<RayHit> cast(const geometry::Ray& ray, const RayLimits& limits = {});
  /// The same for each ray of a fan (collision/scan.h) whose frame is `at`: its distance [m], infinite where nothing is
  /// within the range. As many distances as the fan has rays.
  void cast(const Fan& fan, const Transformd& at, const RayLimits& limits, std::span<double> distances) noexcept;
  /// All shapes on a ray, each where the ray enters it; the nearest first.
  [[nodiscard]] std::vector<RayHit> cast_all(const geometry::Ray& ray, const RayLimits& limits = {});
  /// The bodies that overlap a shape; in the order of entities and objects, each once.
  [[nodiscard]] std::vector<BodyRef> overlapping(const Shape& shape, const Transformd& at);
  /// Nothing if one of the two has no shapes that collide, or is not there. Throws SetupError if an entity is not in the scene.
  [[nodiscard]] std::optional<Separation> distance(const BodyRef& a, const BodyRef& b);

 private:
  /// One entity. Planes stand outside its tree.
  struct Member {
    Member(const Entity& of, const std::string& volume);
    void refresh() noexcept;
    /// The compound, refitted at the first query.
    const Compound& fresh();
    [[nodiscard]] geometry::BoundingSphere reach() const { return {r[0], compound.reach()}; }
    [[nodiscard]] FoundBy found_by() const;
    [[nodiscard]] Transformd pose(const CollidingShape& shape) const;

    const Entity* entity;
    Compound compound;
    std::vector<CollidingShape> planes;
    std::vector<Vec3d> rest_r;  // poses without columns
    std::vector<Mat3d> rest_R;
    std::span<const Vec3d> r;
    std::span<const Mat3d> R;
    std::atomic<bool> stale = true;
    std::mutex refitting;
  };

  [[nodiscard]] Member& member(const Entity* entity) const;
  void update() noexcept;
  /// Calls visit(member), in their order, for those whose sphere of reach is wanted, and a few more (EntityTree::find).
  template <class Wanted, class Visit>
  void for_members(const Wanted& wanted, const Visit& visit);
  template <class Found>
  void for_ray(const geometry::Ray& ray, const RayLimits& limits, double& range, const Found& found);
  struct NearestSearch;
  struct FanCast;

  std::string volume_;
  std::vector<std::unique_ptr<Member>> members_;
  EntityTree near_;  // members by their places
  std::atomic<bool> stale_ = true;
  std::mutex updating_;
};

// ---- definitions ----

template <class Wanted, class Visit>
void QueryScene::for_members(const Wanted& wanted, const Visit& visit) {
  thread_local std::vector<int> near;
  update();
  near_.find(wanted, near);
  for (const int i : near) visit(*members_[i]);
}

}  // namespace murosimf::collision
