/// scene_presence.h - presence in a scene: robots, ball and bodies leave it and return while it runs.
#pragma once

#include <string_view>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Puts an entity at its start (the same seed, the same place), with its present level and laws. Warns
/// if it overlaps others there. Throws SetupError for unknown names, and if it is present already.
void enter(SceneParts& parts, std::string_view entity);

/// Throws SetupError for unknown names and for entities that cannot leave, and if it is absent.
void leave(SceneParts& parts, std::string_view entity);

}  // namespace murosimf::scene
