/// scene_presence.h - who is in a scene: robots, ball and bodies leave it and come back while it runs.
#pragma once

#include <string_view>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Puts an entity where the scene has it begin (the same seed, the same place), at the level and with the laws of now. A warning
/// if somebody stands there. Throws SetupError for unknown names, and if it is there already.
void enter(SceneParts& parts, std::string_view entity);

/// Throws SetupError for unknown names and for what cannot leave, and if it is not there.
void leave(SceneParts& parts, std::string_view entity);

}  // namespace murosimf::scene
