/// level_options.h - options that a robot of a scene passes to its level.
#pragma once

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

[[nodiscard]] catalog::LevelOptions level_options(const RobotSpec& robot);

}  // namespace murosimf::scene_file
