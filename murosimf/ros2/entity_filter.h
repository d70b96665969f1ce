/// entity_filter.h - which entities the filters of simulation_interfaces choose.
#pragma once

#include <functional>
#include <vector>

#include "murosimf/ros2/simulation_messages.h"
#include "murosimf/scene/scene.h"

namespace murosimf::ros2 {

/// Those that are present, by name, category, tags and bounds (bounds_filter.h), of a type that is known. `info`: category and tags of an
/// entity. Throws SetupError: the expression for names is none, or the bounds are none.
[[nodiscard]] std::vector<const Entity*> filtered(const scene::Scene& scene, const EntityFilters& filters,
                                                  const std::function<EntityInfo(const Entity&)>& info);

}  // namespace murosimf::ros2
