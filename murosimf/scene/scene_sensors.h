/// scene_sensors.h - which sensors the robots of a scene carry: those of their files, changed by the scene.
#pragma once

#include <cstddef>

#include "murosimf/scene/model_source.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Attaches those of a robot, given by its number. Notes rates that had to change. Throws SetupError.
void attach_sensors(SceneParts& parts, ModelSource& models, std::size_t robot);

/// What all of them with rays ask; attached when it is first called.
sensors::WorldQueries& shared_queries(SceneParts& parts);

/// Notes what sensors have to say of the level of their robots: one line for robots of which the same is true.
void note_about_sensors(SceneParts& parts);

/// The same of one robot, unless it was said before.
void note_about_sensors(SceneParts& parts, const scene_file::RobotSpec& robot);

}  // namespace murosimf::scene
