#include "murosimf/world/world.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/world/state_hash.h"

namespace murosimf {

// an entity with a base only: it just holds columns
World::World() : common_("world", std::make_shared<const Model>("world", Chain{}.base("world"))) {}

Entity& World::add(std::string name, ModelPtr model, EntityOptions options) {
  MUROSIMF_ASSERT(model);
  if (find(name)) throw SetupError(fmt::format("two entities are called '{}'", name));
  entities_.push_back(std::make_unique<Entity>(std::move(name), std::move(model), std::move(options)));
  return *entities_.back();
}

Entity& World::entity(std::string_view name) const {
  if (Entity* found = find(name)) return *found;
  std::vector<std::string_view> names;
  for (const auto& entity : entities_) names.push_back(entity->name());
  throw SetupError(unknown_name("entity", name, names));
}

Entity* World::find(std::string_view name) const {
  for (const auto& entity : entities_) {
    if (entity->name() == name) return entity.get();
  }
  return nullptr;
}

int World::index_of(const Entity* entity) const {
  const auto found =
      std::find_if(entities_.begin(), entities_.end(), [&](const auto& other) { return other.get() == entity; });
  return entity && found != entities_.end() ? static_cast<int>(found - entities_.begin()) : -1;
}

void World::freeze_columns() {
  for_all([](Entity& entity) { entity.columns().freeze(); });
}

void World::thaw_columns() {
  for_all([](Entity& entity) { entity.columns().thaw(); });
}

std::uint64_t World::state_hash() const {
  Hasher hasher;
  for_all([&](const Entity& entity) { append_state(hasher, entity); });
  return hasher.value();
}

}  // namespace murosimf
