/// start_overlaps.h - overlaps of entities with each other, or with the ground, at the start of a scene.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "murosimf/world/entity.h"

namespace murosimf::scene {

/// One line for each pair of present entities that overlap by more than ordinary contact, with the bodies concerned (of many
/// pairs only for the first), and for each moving entity that penetrates the ground, the plane z = 0. After initialize(); costs
/// microseconds for an entity without neighbors.
[[nodiscard]] std::vector<std::string> start_overlaps(const Entity& field, std::span<Entity* const> moving_entities);

/// The same for an entity that was just added, and the others.
[[nodiscard]] std::vector<std::string> overlaps_of(const Entity& entity, const Entity& field,
                                                   std::span<Entity* const> moving_entities);

}  // namespace murosimf::scene
