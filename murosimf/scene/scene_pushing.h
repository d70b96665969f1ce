/// scene_pushing.h - pushes of a scene: who feels them, and when.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Attaches those of the spec to whom they push, and what lets events of the spec push (or, with `all`, changes push everybody).
/// Throws SetupError, at the push: nobody there who could be pushed, or a level that ignores forces then.
void attach_pushes(SceneParts& parts, bool all);

/// Throws SetupError if nobody can be pushed so.
void check_push(const SceneParts& parts, const scene_file::PushSpec& push, const std::string& entity);
/// Pushes an entity from now on, until the spec's end from now. Throws SetupError if its level ignores forces.
void push(SceneParts& parts, const scene_file::PushSpec& push, const std::string& entity);

}  // namespace murosimf::scene
