/// queries.h - questions about where bodies are: rays, distances and overlaps, for users and sensors.
///
///     QueryScene scene(world);
///     scene.refresh();  // after every step
///     if (const auto hit = scene.cast({eye, forward}, {.without = &robot})) ...
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/collision/compound.h"
#include "murosimf/geometry/distance.h"
#include "murosimf/model/world.h"

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

/// All shapes of a world's entities that collide, planes too. Entities whose level keeps poses are where their columns
/// say, others where their model puts them. Answers do not depend on `volume`, only their cost does.
class QueryScene {
 public:
  /// Of the entities that the world has now; it must outlive the scene. Throws SetupError if there is no such volume.
  explicit QueryScene(const World& world, const std::string& volume = "sphere");

  /// To be called after something has moved; the work is done when a question comes near an entity.
  void refresh() noexcept;

  /// The first shape on a ray; at the same distance, of the entity that was added first.
  [[nodiscard]] std::optional<RayHit> cast(const geometry::Ray& ray, const RayLimits& limits = {});
  /// The same for each ray of a fan (collision/scan.h) whose frame is `at`: its distance [m], infinite where nothing is
  /// within the range. As many distances as the fan has rays.
  void cast(const Fan& fan, const Transformd& at, const RayLimits& limits, std::span<double> distances) noexcept;
  /// All shapes on a ray, each where the ray enters it; the nearest first.
  [[nodiscard]] std::vector<RayHit> cast_all(const geometry::Ray& ray, const RayLimits& limits = {});
  /// The bodies that overlap a shape; in the order of entities and objects, each once.
  [[nodiscard]] std::vector<BodyRef> overlapping(const Shape& shape, const Transformd& at);
  /// Nothing if one of the two has no shapes that collide. Throws SetupError if an entity is not in the scene.
  [[nodiscard]] std::optional<Separation> distance(const BodyRef& a, const BodyRef& b);

 private:
  /// One entity. Planes stand outside its tree.
  struct Member {
    Member(const Entity& of, const std::string& volume);
    void refresh() noexcept;
    /// The compound, refitted if it must be.
    const Compound& fresh();
    [[nodiscard]] geometry::BoundingSphere reach() const { return {r[0], compound.reach()}; }
    [[nodiscard]] Transformd pose(const CollidingShape& shape) const;

    const Entity* entity;
    Compound compound;
    std::vector<CollidingShape> planes;
    std::vector<Vec3d> rest_r;  // poses without columns
    std::vector<Mat3d> rest_R;
    std::span<const Vec3d> r;
    std::span<const Mat3d> R;
    bool stale = true;
  };

  [[nodiscard]] Member& member(const Entity* entity);
  template <class Found>
  void for_ray(const geometry::Ray& ray, const RayLimits& limits, double& range, const Found& found);
  struct NearestSearch;
  struct FanCast;

  std::vector<Member> members_;
};

}  // namespace murosimf::collision
