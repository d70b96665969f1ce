/// scene_entities.h - who is in a scene: field, ball, robots and bodies.
#pragma once

#include "murosimf/scene/model_source.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Adds them to the world, in this order. Throws SetupError.
void add_entities(SceneParts& parts, ModelSource& models);

/// What the world needs to know of an entity.
struct EntitySpec {
  ModelPtr model;
  EntityOptions options;
};
/// Throw SetupError for files and materials that there are none of.
[[nodiscard]] EntitySpec robot_entity(const SceneParts& parts, ModelSource& models, const scene_file::RobotSpec& robot);
[[nodiscard]] EntitySpec body_entity(ModelSource& models, const scene_file::BodySpec& body);

/// Counts one that the world has now among the robots, the bodies of the scene.
void enlist(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity);
void enlist(SceneParts& parts, const scene_file::BodySpec& body, Entity& entity);

}  // namespace murosimf::scene
