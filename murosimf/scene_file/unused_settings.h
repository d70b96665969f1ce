/// unused_settings.h - what a scene sets and nothing uses.
///
/// The rule of docs/scenes.md: what a user sets acts, is refused, or is warned about by name. Levels and controllers say
/// in algorithm_catalog.cpp which keys they use; a level that an event brings later counts, too.
#pragma once

#include <string>
#include <vector>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::catalog {
struct LevelType;
}

namespace murosimf::scene_file {

/// The levels at which a robot is at a time [s] or later, as far as events are foreseen.
[[nodiscard]] std::vector<const catalog::LevelType*> levels_from(const SceneSpec& spec, const RobotSpec& robot,
                                                                 double time);

/// One line for each key of the scene that changes nothing, however it was set: in the file, by --set or as an event.
[[nodiscard]] std::vector<std::string> unused_keys(const SceneSpec& spec);

/// One line for each pair of [[materials]] of which nothing in the scene consists. `used`: materials of all bodies.
/// Throws SetupError, with the nearest name, for a material that nobody knows.
[[nodiscard]] std::vector<std::string> unused_pairs(const SceneSpec& spec, const std::vector<std::string>& used);

/// A line if the pile of the ground leans and nothing of these materials feels it; else empty.
[[nodiscard]] std::string unused_friction_direction(const SceneSpec& spec, const std::vector<std::string>& used);

}  // namespace murosimf::scene_file
