/// scene_state.h - the state of a scene as bytes: its simulation's, its seed, and exchanged algorithms: levels, laws,
/// light and ball.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

[[nodiscard]] std::vector<std::byte> save_state(SceneParts& parts);

/// Throws SetupError, and changes nothing, if it is no state of such a scene.
void load_state(SceneParts& parts, std::span<const std::byte> bytes);

}  // namespace murosimf::scene
