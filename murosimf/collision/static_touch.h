/// static_touch.h - where one entity touches the static shapes of its environment.
#pragma once

#include <utility>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/static_compound.h"

namespace murosimf::collision {

class StaticTouch {
 public:
  StaticTouch(const Entity& entity, const Entity* environment);

  [[nodiscard]] const Compound& own() const { return own_; }
  [[nodiscard]] const Compound& environment() const { return environment_.compound(); }

  /// Appends contacts, sorted by feature; their `feature` begins at `first_feature`, and `surface` is that of shape i of
  /// the entity and shape j of the environment at first_surface + j * shapes + i. The caller fills in what depends on the
  /// pair of surfaces, velocities and memory. r [m], R: poses of the entity's objects.
  void find(std::span<const Vec3d> r, std::span<const Mat3d> R, std::uint64_t first_feature,
            std::uint32_t first_surface, std::vector<ContactPoint>& found, TestCounts& tests) noexcept;

 private:
  Compound own_;
  StaticCompound environment_;
  std::vector<std::pair<int, int>> candidates_;  // of the environment and its own whose volumes overlap; working memory
};

}  // namespace murosimf::collision
