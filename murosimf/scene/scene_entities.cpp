#include "murosimf/scene/scene_entities.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/random.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene_file/field.h"

namespace murosimf::scene {
namespace {

/// Bodies that stand are part of it.
void add_field(SceneParts& parts, const ModelSource& models) {
  std::vector<Chain> standing;
  for (const scene_file::BodySpec& body : parts.spec.bodies) {
    if (body.is_static) standing.push_back(scene_file::static_body(body));
  }
  const scene_file::FieldSpec& field = parts.spec.field;
  const ModelPtr model = scene_file::field_model(scene_file::field_size(field.size), field.surface,
                                                 field.friction_direction, field.goals, standing);
  parts.field = &parts.simulation->world().add("field", model);
  models.check_materials(*model);
}

void add_ball(SceneParts& parts, ModelSource& models) {
  EntityOptions options;
  options.position = parts.spec.ball->position;
  const ModelPtr model = models.changed_for("ball", scene_file::ball_model(*parts.spec.ball));
  models.check_materials(*model);
  options.color = model->find(properties::shapes, 0)->front().color;
  parts.ball = &parts.simulation->world().add("ball", model, options);
  parts.ball->level = "simplified_dynamics";
  parts.ball->contact = parts.spec.ball->contact;
  parts.moving_entities.push_back(parts.ball);
}

/// A turn about any axis, by up to `largest` [rad].
Mat3d random_tilt(const RandomStream& random, double largest) {
  const double z = random.uniform(3, -1, 1), longitude = random.uniform(4, -pi, pi), across = std::sqrt(1 - z * z);
  return rotation(Vec3d{across * std::cos(longitude), across * std::sin(longitude), z},
                  random.uniform(5, -largest, largest));
}

EntityOptions options_of(const scene_file::SceneSpec& spec, const scene_file::RobotSpec& robot) {
  EntityOptions options;
  const RandomStream random(spec.seed, robot.name + "/start");
  const double j = spec.jitter_position;
  options.position = robot.position + Vec3d{random.uniform(0, -j, j), random.uniform(1, -j, j), 0};
  options.heading = robot.heading + random.uniform(2, -spec.jitter_heading, spec.jitter_heading);
  options.attitude = random_tilt(random, spec.jitter_tilt) * rotation_y(robot.pitch) * rotation_x(robot.roll);
  options.collision = robot.collision;
  options.team = robot.team;
  for (const scene_file::TeamSpec& team : spec.teams) {
    if (team.name == robot.team) options.color = team.color;
  }
  return options;
}

void add_robot(SceneParts& parts, ModelSource& models, const scene_file::RobotSpec& robot) {
  const EntityOptions options = options_of(parts.spec, robot);
  const ModelPtr model = models.changed_for(robot.name, models.robot(robot.model, robot.where).model);
  Entity& entity =
      with_context(robot.where, [&]() -> Entity& { return parts.simulation->world().add(robot.name, model, options); });
  entity.level = robot.level;
  entity.controller = robot.controller;
  parts.robots.push_back(&entity);
  parts.moving_entities.push_back(&entity);
}

void add_body(SceneParts& parts, ModelSource& models, const scene_file::BodySpec& body) {
  EntityOptions options;
  options.position = body.position;
  options.heading = body.heading;
  options.attitude = rotation_y(body.pitch) * rotation_x(body.roll);
  options.color = body.color;
  const ModelPtr own = body.shape ? scene_file::body_model(body) : models.robot(body.model, body.where).model;
  models.check_materials(*own);
  Entity& entity = parts.simulation->world().add(body.name, models.changed_for(body.name, own), options);
  entity.level = "simplified_dynamics";
  entity.contact = body.contact;
  parts.bodies.push_back(&entity);
  parts.moving_entities.push_back(&entity);
}

}  // namespace

void add_entities(SceneParts& parts, ModelSource& models) {
  add_field(parts, models);
  if (parts.spec.ball) add_ball(parts, models);
  for (const scene_file::RobotSpec& robot : parts.spec.robots) add_robot(parts, models, robot);
  for (const scene_file::BodySpec& body : parts.spec.bodies) {
    if (!body.is_static) with_context(body.where, [&] { add_body(parts, models, body); });
  }
}

void start_moving(SceneParts& parts) {
  if (parts.ball) parts.ball->base().set(properties::linear_velocity, parts.spec.ball->velocity);
  for (Entity* entity : parts.bodies) {
    const scene_file::BodySpec& body = *body_spec(parts.spec, *entity);
    entity->base().set(properties::linear_velocity, body.velocity);
    entity->base().set(properties::angular_velocity, body.angular_velocity);
  }
}

void scatter_postures(SceneParts& parts) {
  const double largest = parts.spec.jitter_posture;
  if (largest == 0) return;
  for (Entity* robot : parts.robots) {
    const RandomStream random(parts.spec.seed, robot->name() + "/posture");
    auto& targets = robot->column(properties::joint_target).values;
    for (const int joint : robot->model().joints()) {
      const Vec3d* range = robot->model().find(properties::joint_range, joint);
      const double angle = random.uniform(static_cast<std::uint64_t>(joint), -largest, largest);
      targets[joint] = range ? std::clamp(angle, range->x, range->y) : angle;
    }
  }
}

}  // namespace murosimf::scene
