#include "murosimf/model/world.h"

#include <fmt/format.h>

namespace murosimf {

Entity& World::add(std::string name, ModelPtr model, EntityOptions options) {
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

void World::freeze_columns() {
  for (const auto& entity : entities_) entity->freeze_columns();
}

void World::thaw_columns() {
  for (const auto& entity : entities_) entity->thaw_columns();
}

std::uint64_t World::state_hash() const {
  Hasher hasher;
  for (const auto& entity : entities_) entity->append_to(hasher);
  return hasher.value();
}

}  // namespace murosimf
