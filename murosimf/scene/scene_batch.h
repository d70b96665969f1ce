/// scene_batch.h - changes of a running scene that are made together or not at all.
#pragma once

#include <string>
#include <vector>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Scene::change.
void change_all(SceneParts& parts, const std::vector<std::string>& changes);

}  // namespace murosimf::scene
