/// static_compound.h - the shapes of an environment that never move: goals, walls, boxes on the field. Planes stand apart.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "murosimf/collision/compound.h"
#include "murosimf/collision/relief/relief.h"
#include "murosimf/world/entity.h"

namespace murosimf::collision {

class StaticCompound {
 public:
  /// `environment` stands at the world's origin; null: nothing there.
  explicit StaticCompound(const Entity* environment);

  [[nodiscard]] bool empty() const { return places_.empty(); }
  [[nodiscard]] const Compound& compound() const { return compound_; }
  [[nodiscard]] const CollidingShape& shape(int i) const { return compound_.shapes()[i]; }
  [[nodiscard]] const Transformd& pose(int i) const { return places_[i]; }

  /// Uneven ground, whose shapes are prisms below its triangles.
  struct Ground {
    ReliefPtr relief;
    Transformd at;   ///< world
    int object = 0;  ///< of the environment
    int first = 0;   ///< shape: that of its triangle 0
    [[nodiscard]] bool has(int i) const {
      return i >= first && i < first + static_cast<int>(relief->triangles().size());
    }
  };
  [[nodiscard]] const std::vector<Ground>& uneven_grounds() const { return grounds_; }
  /// The uneven ground that shape i belongs to; null if it is something else.
  [[nodiscard]] const Ground* ground_of(int i) const noexcept;
  /// [m] Of shape i (interpenetration.h); that of the whole ground if it is a part of one.
  [[nodiscard]] double thickness(int i) const { return thicknesses_[static_cast<std::size_t>(i)]; }

  /// True if the sphere about `center` [m] meets any shape; adds the tests of volumes to `tests`.
  [[nodiscard]] bool is_near(const Vec3d& center, double radius, std::int64_t& tests) const noexcept;

 private:
  Compound compound_;
  std::vector<Transformd> places_;   // of each shape, world
  std::vector<double> thicknesses_;  // [m] of each shape
  std::vector<Ground> grounds_;
};

/// The compound that all entities in this environment share.
[[nodiscard]] std::shared_ptr<const StaticCompound> static_compound_of(const Entity* environment);

/// Whether an entity may touch something static. An answer holds while the base has not moved far: it is asked for a sphere that is
/// bigger by as much.
class NearStatics {
 public:
  /// `reach` [m]: of the entity about its `base` [m], always the same.
  [[nodiscard]] bool operator()(const StaticCompound& environment, const Vec3d& base, double reach,
                                std::int64_t& tests) noexcept;

 private:
  std::optional<Vec3d> asked_at_;  // [m] of the base, when it was last asked
  bool near_ = false;              // the answer
};

}  // namespace murosimf::collision
