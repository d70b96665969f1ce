/// scene_entities.h - who is in a scene: field, ball, robots and bodies, where they begin.
#pragma once

#include "murosimf/scene/model_source.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Adds them to the world, in this order. Throws SetupError.
void add_entities(SceneParts& parts, ModelSource& models);

/// Gives ball and bodies the velocities with which they begin. After initialize().
void start_moving(SceneParts& parts);

/// Turns joint targets away from zero, by up to jitter_posture; controllers that set them are stronger.
void scatter_postures(SceneParts& parts);

}  // namespace murosimf::scene
