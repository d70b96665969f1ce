/// scene_pushing.h - pushes of a scene: who feels them, and when.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Attaches those of the spec to whom they push. Throws SetupError, at the push: nobody there who could be pushed, or a level
/// that ignores forces then.
void attach_pushes(SceneParts& parts);

}  // namespace murosimf::scene
