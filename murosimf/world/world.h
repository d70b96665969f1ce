/// world.h - all entities of a simulation, by name, and their common data. Data only; time belongs to runtime.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/world/entity.h"

namespace murosimf {

class World {
 public:
  World();

  /// Throws SetupError if the name is taken.
  Entity& add(std::string name, ModelPtr model, EntityOptions options = {});

  [[nodiscard]] Entity& entity(std::string_view name) const;  ///< throws SetupError with the nearest name
  [[nodiscard]] Entity* find(std::string_view name) const;    ///< null if there is none
  /// Place of an entity in entities(), where it stays; -1 for null and for one of another world.
  [[nodiscard]] int index_of(const Entity* entity) const;
  [[nodiscard]] const std::vector<std::unique_ptr<Entity>>& entities() const { return entities_; }
  /// Removes and destroys the entity that was added last, to which no references may exist.
  void take_back_last() {
    MUROSIMF_ASSERT(!entities_.empty());
    entities_.pop_back();
  }

  /// Has the columns of the whole world, which belong to no entity (contacts between them). It is called "world" and is none of
  /// entities().
  [[nodiscard]] Entity& common() { return common_; }
  [[nodiscard]] const Entity& common() const { return common_; }
  /// Calls visit(entity) for all entities in their order, then for common().
  template <class Visit>
  void for_all(const Visit& visit) const {
    for (const auto& entity : entities_) visit(*entity);
    visit(common_);
  }

  void freeze_columns();
  void thaw_columns();

  /// Hash of every column of every entity: equal states give equal hashes.
  [[nodiscard]] std::uint64_t state_hash() const;

  Vec3d gravity{0, 0, -9.81};  ///< [m/s^2] world frame

 private:
  std::vector<std::unique_ptr<Entity>> entities_;
  mutable Entity common_;
};

}  // namespace murosimf
