/// level_options.h - what a robot of a scene asks of its level.
#pragma once

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

[[nodiscard]] catalog::LevelOptions level_options(const RobotSpec& robot);

}  // namespace murosimf::scene_file
