/// scene_builder.h - builds a scene from its spec: entities, and the algorithms attached to them, in their order.
#pragma once

#include "murosimf/scene/scene_options.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Fills parts that contain only the spec and an empty simulation. Throws SetupError.
void build(SceneParts& parts, const SceneOptions& options);

}  // namespace murosimf::scene
