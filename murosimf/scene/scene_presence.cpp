#include "murosimf/scene/scene_presence.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/scene/scene_settings.h"
#include "murosimf/scene/scene_start.h"
#include "murosimf/scene/start_overlaps.h"

namespace murosimf::scene {
namespace {

Entity& moving_entity(const SceneParts& parts, std::string_view name) {
  Entity& entity = parts.simulation->world().entity(name);
  if (std::ranges::find(parts.moving_entities, &entity) == parts.moving_entities.end()) {
    throw SetupError(fmt::format("'{}' does not move; it is always there", name));
  }
  return entity;
}

}  // namespace

/// Placed while it enters, so that no step sees it at its old place.
void enter(SceneParts& parts, std::string_view name) {
  Entity& entity = moving_entity(parts, name);
  parts.simulation->enter(entity, [&](Entity& entering) { place_at_start(parts, entering); });
  start_moving(parts, entity);
  apply_settings_of(parts, entity);
  parts.diagnostics.warn(overlaps_of(entity, *parts.field, parts.moving_entities));
}

void leave(SceneParts& parts, std::string_view name) { parts.simulation->leave(moving_entity(parts, name)); }

}  // namespace murosimf::scene
