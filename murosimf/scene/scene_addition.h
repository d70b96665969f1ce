/// scene_addition.h - robots and bodies that are added to an existing scene.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// With their algorithms, as if they were last in the scene; see Scene::add. Throw SetupError, and change nothing.
Entity& add(SceneParts& parts, scene_file::RobotSpec robot);
Entity& add(SceneParts& parts, scene_file::BodySpec body);

}  // namespace murosimf::scene
