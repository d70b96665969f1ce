/// scene_sensors.h - sensors of the robots of a scene: those of their files, changed by the scene.
#pragma once

#include <cstddef>

#include "murosimf/scene/model_source.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Attaches those of a robot, given by its number. Notes rates that had to change. Throws SetupError.
void attach_sensors(SceneParts& parts, ModelSource& models, std::size_t robot);

/// World queries shared by all of them with rays; attached at the first call.
sensors::WorldQueries& shared_queries(SceneParts& parts);

/// Notes diagnostics of sensors about the level of their robots: one line for robots with the same diagnostic.
void note_about_sensors(SceneParts& parts);

/// The same for one robot, unless it was noted before.
void note_about_sensors(SceneParts& parts, const scene_file::RobotSpec& robot);

}  // namespace murosimf::scene
