/// scene_entities.h - the entities of a scene: field, ball, robots and bodies.
#pragma once

#include "murosimf/scene/model_source.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Adds them to the world, in this order. Throws SetupError.
void add_entities(SceneParts& parts, ModelSource& models);

/// The world's input for an entity.
struct EntitySpec {
  ModelPtr model;
  EntityOptions options;
};
/// Throw SetupError for unknown files and materials.
[[nodiscard]] EntitySpec robot_entity(const SceneParts& parts, ModelSource& models, const scene_file::RobotSpec& robot);
[[nodiscard]] EntitySpec body_entity(ModelSource& models, const scene_file::BodySpec& body);

/// Registers an entity of the world among the robots or the bodies of the scene.
void enlist(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity);
void enlist(SceneParts& parts, const scene_file::BodySpec& body, Entity& entity);

}  // namespace murosimf::scene
