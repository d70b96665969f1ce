#include "murosimf/scene/scene_entities.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/start_posture.h"
#include "murosimf/scene_file/field.h"

namespace murosimf::scene {
namespace {

/// Static bodies are part of it; scenes share only fields without any.
ModelPtr field_of(const scene_file::FieldSpec& field, const std::vector<Chain>& standing, Assets& assets) {
  const scene_file::FieldSize& size = scene_file::field_size(field.size);
  const bool nets = field.goals && field.nets.value_or(size.nets);
  const auto make = [&] {
    return scene_file::field_model(size, field.surface, field.friction_direction,
                                   {.goals = field.goals, .nets = nets, .poles = field.landmark_poles}, standing);
  };
  if (!standing.empty()) return make();
  const Vec3d& pile = field.friction_direction;
  // every input of `make` is in the key
  return assets.model(fmt::format("field {} {} {} {} {} {} {} {}", field.size, field.goals, nets, field.landmark_poles,
                                  pile.x, pile.y, pile.z, field.surface),
                      make);
}

/// Static bodies are part of the field: contacts with them need no second entity.
void add_field(SceneParts& parts, const ModelSource& models) {
  std::vector<Chain> standing;
  for (const scene_file::BodySpec& body : parts.spec.bodies) {
    if (body.is_static) standing.push_back(scene_file::static_body(body));
  }
  const ModelPtr model = field_of(parts.spec.field, standing, *parts.assets);
  parts.field = &parts.simulation->world().add("field", model);
  models.check_materials(*model);
}

void add_ball(SceneParts& parts, ModelSource& models) {
  EntityOptions options;
  options.position = parts.spec.ball->position;
  options.present = parts.spec.ball->present;
  const ModelPtr model = models.changed_for("ball", scene_file::ball_model(*parts.spec.ball));
  models.check_materials(*model);
  options.color = parts.spec.ball->color;
  parts.ball = &parts.simulation->world().add("ball", model, options);
  parts.ball->level = "simplified_dynamics";
  parts.ball->contact = parts.spec.ball->contact;
  parts.moving_entities.push_back(parts.ball);
}

/// Levels step by whole multiples of the scene's step: other rates cannot be kept.
int step_multiple_of(const scene_file::SceneSpec& spec, const scene_file::RobotSpec& robot) {
  if (robot.rate == 0) return 1;
  const double steps = spec.rate / robot.rate;
  if (!(std::round(steps) >= 1) || std::abs(steps - std::round(steps)) > 1e-6 * steps) {
    throw SetupError(fmt::format("'rate' of robot '{}', {} Hz: the scene's steps, {} Hz, are no whole multiple of it",
                                 robot.name, robot.rate, spec.rate));
  }
  if (steps > 1.5 && robot.collision.self_collision) {
    throw SetupError(
        fmt::format("'rate' of robot '{}' does not go with self_collision, which needs the scene's steps", robot.name));
  }
  return static_cast<int>(std::lround(steps));
}

EntityOptions options_of(const scene_file::SceneSpec& spec, const scene_file::RobotSpec& robot) {
  EntityOptions options;
  options.position = robot.position;
  options.present = robot.present;
  options.collision = robot.collision;
  options.team = robot.team;
  options.base_level = !robot.keyframe.empty();
  options.step_multiple = with_context(robot.where, [&] { return step_multiple_of(spec, robot); });
  for (const scene_file::TeamSpec& team : spec.teams) {
    if (team.name == robot.team) options.color = team.color;
  }
  return options;
}

}  // namespace

EntitySpec robot_entity(const SceneParts& parts, ModelSource& models, const scene_file::RobotSpec& robot) {
  const ModelPtr model = models.changed_for(robot.name, models.robot(robot).model);
  with_context(robot.where, [&] { (void)find_keyframe(*model, robot.keyframe); });
  return {model, options_of(parts.spec, robot)};
}

EntitySpec body_entity(ModelSource& models, const scene_file::BodySpec& body) {
  EntityOptions options;
  options.position = body.position;
  options.heading = body.heading;
  options.attitude = rotation_y(body.pitch) * rotation_x(body.roll);
  options.color = body.color;
  options.present = body.present;
  const ModelPtr own = body.shape ? scene_file::body_model(body) : models.robot(body).model;
  models.check_materials(*own);
  return {models.changed_for(body.name, own), options};
}

void enlist(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity) {
  entity.level = robot.level;
  entity.controller = robot.controller;
  parts.robots.push_back(&entity);
  parts.moving_entities.push_back(&entity);
}

void enlist(SceneParts& parts, const scene_file::BodySpec& body, Entity& entity) {
  entity.level = "simplified_dynamics";
  entity.contact = body.contact;
  parts.bodies.push_back(&entity);
  parts.moving_entities.push_back(&entity);
}

/// The order of the entities is that of their numbers: field, ball, robots, bodies.
void add_entities(SceneParts& parts, ModelSource& models) {
  add_field(parts, models);
  if (parts.spec.ball) add_ball(parts, models);
  World& world = parts.simulation->world();
  for (const scene_file::RobotSpec& robot : parts.spec.robots) {
    const EntitySpec kind = robot_entity(parts, models, robot);
    with_context(robot.where, [&] { enlist(parts, robot, world.add(robot.name, kind.model, kind.options)); });
  }
  for (const scene_file::BodySpec& body : parts.spec.bodies) {
    if (body.is_static) continue;
    with_context(body.where, [&] {
      const EntitySpec kind = body_entity(models, body);
      enlist(parts, body, world.add(body.name, kind.model, kind.options));
    });
  }
  MUROSIMF_ASSERT(parts.robots.size() == parts.spec.robots.size());
}

}  // namespace murosimf::scene
