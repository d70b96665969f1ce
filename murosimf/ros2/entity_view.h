/// entity_view.h - entities of a running scene as simulation_interfaces sees them, and the commands of a run that place them.
#pragma once

#include <string>
#include <vector>

#include "murosimf/ros2/simulation_messages.h"
#include "murosimf/scene/scene.h"

namespace murosimf::ros2 {

[[nodiscard]] Category category_of(const scene::Scene& scene, const Entity& entity);
/// Its model and its team.
[[nodiscard]] std::vector<std::string> tags_of(const Entity& entity);

/// One that moves, present or not; null: there is none.
[[nodiscard]] const Entity* find_entity(const scene::Scene& scene, const std::string& name);

/// Of its base, in the world.
[[nodiscard]] EntityState state_of(const scene::Scene& scene, const Entity& entity);

/// Its shapes that collide, as they are, in a box along the axes of its base; without shapes: unbounded.
[[nodiscard]] Bounds bounds_of(const Entity& entity);

/// Commands (Scene::change) by which it gets there.
[[nodiscard]] std::vector<std::string> changes_to(const Entity& entity, const EntityState& state);

/// Empty: it is one. Normalizes the orientation.
[[nodiscard]] std::string trouble_with(EntityState& state);

}  // namespace murosimf::ros2
