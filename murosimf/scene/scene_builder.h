/// scene_builder.h - builds what a scene file says: entities, and the algorithms that are attached to them, in their order.
#pragma once

#include "murosimf/scene/scene_options.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Fills parts that have nothing but the spec and an empty simulation. Throws SetupError.
void build(SceneParts& parts, const SceneOptions& options);

}  // namespace murosimf::scene
