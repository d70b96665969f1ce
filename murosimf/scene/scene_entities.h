/// scene_entities.h - who is in a scene: field, ball, robots and bodies.
#pragma once

#include "murosimf/scene/model_source.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Adds them to the world, in this order. Throws SetupError.
void add_entities(SceneParts& parts, ModelSource& models);

}  // namespace murosimf::scene
