/// scene_algorithms.h - the algorithms of one entity of a scene. Those of different phases may be attached in any order.
#pragma once

#include <string>

#include "murosimf/scene/scene_parts.h"

namespace murosimf::catalog {
struct LevelOptions;
}

namespace murosimf::scene {

/// All throw SetupError for unknown names, and with the place in the scene file for what an algorithm refuses.
void attach_controller(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity);

/// Attaches the exchange of team messages, if the software of the entity has requested messages and none is attached yet.
void attach_messages(SceneParts& parts, const Entity& entity);

/// Also for entities at levels without forces, since they may change their level. `level`: the initial one.
void attach_ground_contact(SceneParts& parts, Entity& entity, const std::string& level, const std::string& law,
                           const OptionValues& options = {});

/// For balls and other spheres, after the contact with the ground; nothing without air.
void attach_air(SceneParts& parts, Entity& entity);
/// Options that a robot passes to its level, on the ground of the scene.
[[nodiscard]] catalog::LevelOptions level_options(const SceneParts& parts, const scene_file::RobotSpec& robot);

/// The level that the entity names.
void attach_level(SceneParts& parts, Entity& entity, const catalog::LevelOptions& options);
/// The same with the options of a robot; warns about settings that users overlook.
/// The same with the options of a robot; warnings about what a user may have overlooked.
void attach_level_of(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity);
/// Separate steps for an entity that requests them; nothing for others. One algorithm serves all of them.
/// Steps of its own for an entity that has them; does nothing for others, and for all but the first.
void attach_multirate_stepping(SceneParts& parts, const Entity& entity);
/// Counts distance and falls.
/// Counts its way and its falls.
void attach_odometer(SceneParts& parts, Entity& entity);
/// Nothing if the robot does not request them.
/// Nothing if the robot does not ask for them.
void attach_accelerations(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity);

}  // namespace murosimf::scene
