/// unused_settings.h - settings of a scene without effect.
///
/// The rule of docs/scenes.md: a user's setting has an effect, is refused, or is warned about by name. Levels and controllers declare
/// in algorithm_catalog.cpp which keys they use; a level that an event sets later counts, too.
#pragma once

#include <string>
#include <vector>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::catalog {
struct LevelType;
}

namespace murosimf::scene_file {

/// Levels of a robot at a time [s] or later, as far as events define them.
[[nodiscard]] std::vector<const catalog::LevelType*> levels_from(const SceneSpec& spec, const RobotSpec& robot,
                                                                 double time);

/// One line for each key of the scene without effect, wherever it was set: in the file, by --set or as an event.
[[nodiscard]] std::vector<std::string> unused_keys(const SceneSpec& spec);

/// One line for each pair of [[materials]] with a material that no body in the scene has. `used`: materials of all bodies.
/// Throws SetupError, with the nearest name, for an unknown material.
[[nodiscard]] std::vector<std::string> unused_pairs(const SceneSpec& spec, const std::vector<std::string>& used);

/// A line if the pile of the ground leans and no contact with these materials depends on it; else empty.
[[nodiscard]] std::string unused_friction_direction(const SceneSpec& spec, const std::vector<std::string>& used);

}  // namespace murosimf::scene_file
