/// scene_pushing.h - pushes of a scene: their targets and times.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Attaches the pushes of the spec to their targets, and pushes for events of the spec (or, with `all`, for changes of every moving entity).
/// Throws SetupError, at the push: no such entity that can be pushed, or its level ignores forces at that time.
void attach_pushes(SceneParts& parts, bool all);

/// Throws SetupError if the entity cannot be pushed like this.
void check_push(const SceneParts& parts, const scene_file::PushSpec& push, const std::string& entity);
/// Pushes an entity from now on, until the spec's end from now. Throws SetupError if its level ignores forces.
void push(SceneParts& parts, const scene_file::PushSpec& push, const std::string& entity);

}  // namespace murosimf::scene
