/// scene_addition.h - robots and bodies that come into a scene that is built already.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// With their algorithms, as if the scene had had them last; see Scene::add. Throw SetupError, and change nothing.
Entity& add(SceneParts& parts, scene_file::RobotSpec robot);
Entity& add(SceneParts& parts, scene_file::BodySpec body);

}  // namespace murosimf::scene
