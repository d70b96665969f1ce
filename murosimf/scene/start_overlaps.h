/// start_overlaps.h - who stands in whom, or in the ground, when a scene begins.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "murosimf/model/entity.h"

namespace murosimf::scene {

/// One line for each pair of entities that are there and overlap by more than contact ever does, with the bodies that do it (of many
/// pairs only for the first), and for each moving entity that is in the ground, the plane z = 0. After initialize(); costs
/// microseconds for who is near nobody.
[[nodiscard]] std::vector<std::string> start_overlaps(const Entity& field, std::span<Entity* const> moving_entities);

/// The same for an entity that has just come, and the others.
[[nodiscard]] std::vector<std::string> overlaps_of(const Entity& entity, const Entity& field,
                                                   std::span<Entity* const> moving_entities);

}  // namespace murosimf::scene
