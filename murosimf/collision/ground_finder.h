/// ground_finder.h - contacts of one entity with its environment: the ground's planes, and static shapes on it.
///
/// Planes stand outside the trees: a plane's sphere of reach is one dot product per shape (paper 5, and ground_points.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/ground_points.h"
#include "murosimf/collision/interpenetration.h"
#include "murosimf/collision/relief/relief_contact.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/collision/surface_kinds.h"

namespace murosimf::collision {

class GroundLanes;

class GroundFinder {
 public:
  /// `environment`: null for none.
  GroundFinder(const Entity& entity, const Entity* environment);

  /// The two surfaces of a value of Contact::surface: one value for every pair of kinds, whatever number of shapes they have.
  struct Meeting {
    const Surface &own, &other;
    Vec3d friction_direction;  ///< [1] of the environment (GroundPlane)
    int object = 0;            ///< of the environment
    double thickness = 0;      ///< [m] of that object (interpenetration.h), infinite for a plane
  };
  /// Calls add(meeting) for each of them.
  template <class Add>
  void for_meetings(const Add& add) const {
    for (const GroundPlane& plane : planes_) {
      for (const Surface& own : own_kinds_.surfaces())
        add(Meeting{own, plane.surface, plane.friction_direction, plane.object,
                    std::numeric_limits<double>::infinity()});
    }
    for (std::size_t i = 0; i < static_kinds_.surfaces().size(); ++i) {
      const int object = static_kinds_.objects()[i];
      for (const Surface& own : own_kinds_.surfaces())
        add(Meeting{own, static_kinds_.surfaces()[i], {}, object, environment_->compound().thickness_of(object)});
    }
  }
  /// [m] of a body of the entity.
  [[nodiscard]] double own_thickness(int object) const noexcept { return own_.thickness_of(object); }
  /// Whether both points are of the same two shapes.
  [[nodiscard]] static bool are_of_same_shapes(const ContactPoint& a, const ContactPoint& b) noexcept;
  /// Whether a point is on a plane, whose normal never turns.
  [[nodiscard]] static bool is_on_plane(const ContactPoint& point) noexcept;
  /// Largest number of contacts with planes.
  [[nodiscard]] std::size_t most_on_planes() const;

  /// Discards the cached test whether static shapes are near; results do not depend on it.
  void forget_nearness() noexcept { is_near_statics_ = {}; }
  /// Appends contacts, sorted by feature; geometry and `surface` only. r [m], R: poses of the entity's objects.
  void find(std::span<const Vec3d> r, std::span<const Mat3d> R, std::vector<ContactPoint>& found,
            TestCounts& tests) noexcept;
  /// The parts of find(): contacts with planes, and those with static shapes.
  void find_on_planes(std::span<const Vec3d> r, std::span<const Mat3d> R, std::vector<ContactPoint>& found,
                      TestCounts& tests) const noexcept;
  void find_on_statics(std::span<const Vec3d> r, std::span<const Mat3d> R, std::vector<ContactPoint>& found,
                       TestCounts& tests) noexcept;
  /// Whether both find the same contacts with planes from the same poses.
  [[nodiscard]] bool finds_like(const GroundFinder& other) const noexcept {
    return shapes_ == other.shapes_ && environment_ == other.environment_ &&
           all_touch_planes_ == other.all_touch_planes_;
  }

 private:
  friend GroundLanes;

  void add_contacts(int own, int other, const geometry::Manifold& manifold,
                    std::vector<ContactPoint>& found) const noexcept;
  void find_candidates(std::span<const Vec3d> r, std::span<const Mat3d> R, TestCounts& tests) noexcept;
  void find_on_ground(const StaticCompound::Ground& ground, std::span<const Vec3d> r, std::span<const Mat3d> R,
                      std::span<const std::pair<int, int>> candidates, std::vector<ContactPoint>& found,
                      TestCounts& tests) noexcept;
  [[nodiscard]] std::uint32_t surface(std::size_t other_kind, std::size_t own_shape) const noexcept;

  const std::vector<GroundShape>* shapes_;  // the model's
  std::vector<GroundPlane> planes_;
  std::shared_ptr<const StaticCompound> environment_;
  Compound own_;
  SurfaceKinds own_kinds_, static_kinds_;
  bool all_touch_planes_;
  NearStatics is_near_statics_;
  std::vector<std::pair<int, int>> candidates_;  // shapes, of the environment and its own, whose volumes overlap
  bool has_candidates_ = false;                  // which hold until something has left its volume
  std::vector<int> triangles_;                   // of uneven ground, near one of its shapes
  std::vector<ReliefContact> on_ground_;         // of that shape
};

/// The ground planes among the shapes of an environment that collide.
[[nodiscard]] std::vector<GroundPlane> ground_planes(const Entity* environment);

/// The plane that touches the ground below a point: z = height + slope_x (x - point.x) + slope_y (y - point.y).
struct GroundBelow {
  double height = 0;                ///< [m] right below the point
  double slope_x = 0, slope_y = 0;  ///< [1] dz/dx, dz/dy
};

/// The ground that carries an entity that steps on an environment from above: its planes, and static shapes on them.
class GroundSurface {
 public:
  /// Surfaces that are higher than this above a point [m] are not below it, but beside.
  static constexpr double highest_step = 0.06;
  /// [1] cosine of the angle between the vertical and the steepest surface to stand on; steeper surfaces count as level.
  static constexpr double steepest = 0.8660254037844387;  // 30 degrees

  /// `environment`: null for none, then the ground is the plane z = 0, as it is where no plane is below a point.
  explicit GroundSurface(const Entity* environment);

  /// The ground below a point [m] of the world. Caches whether static shapes are near, which changes no result.
  [[nodiscard]] GroundBelow below(const Vec3d& point) noexcept;

 private:
  std::vector<GroundPlane> planes_;
  std::shared_ptr<const StaticCompound> statics_;  // null: nothing stands there
  NearStatics is_near_;
};

}  // namespace murosimf::collision
