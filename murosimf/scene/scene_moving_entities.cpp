// Bodies of a scene that are no robots: those that move are entities, those that stand are part of the field.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/collision/ground_contact.h"
#include "murosimf/files/data_path.h"
#include "murosimf/scene/field.h"
#include "murosimf/scene/registry.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {

void Scene::add_field() {
  std::vector<Chain> standing;
  for (const BodySpec& body : spec_.bodies) {
    if (body.is_static) standing.push_back(static_body(body));
  }
  const FieldSpec& field = spec_.field;
  const ModelPtr model =
      field_model(field_size(field.size), field.surface, field.friction_direction, field.goals, standing);
  field_ = &simulation_->world().add("field", model);
  check_materials(*model);
}

void Scene::add_bodies() {
  for (const BodySpec& body : spec_.bodies) {
    if (!body.is_static) with_context(body.where, [&] { add_body(body); });
  }
}

void Scene::add_body(const BodySpec& body) {
  EntityOptions options;
  options.position = body.position;
  options.heading = body.heading;
  options.attitude = rotation_y(body.pitch) * rotation_x(body.roll);
  options.color = body.color;
  const ModelPtr own = body.shape ? body_model(body) : model(body.model, body.where);
  check_materials(*own);
  Entity& entity = simulation_->world().add(body.name, model_for(body.name, own), options);
  entity.level = "simplified_dynamics";
  entity.contact = body.contact;
  bodies_.push_back(&entity);
  moving_entities_.push_back(&entity);
}

const BodySpec* Scene::body_spec(const Entity& entity) const {
  for (const BodySpec& body : spec_.bodies) {
    if (body.name == entity.name()) return &body;
  }
  return nullptr;
}

void Scene::start_bodies() {
  for (Entity* entity : bodies_) {
    const BodySpec& body = *body_spec(*entity);
    entity->base().set(properties::linear_velocity, body.velocity);
    entity->base().set(properties::angular_velocity, body.angular_velocity);
  }
}

void Scene::warn_about_static_bodies() {
  const auto stands = [](const BodySpec& body) { return body.is_static; };
  if (std::none_of(spec_.bodies.begin(), spec_.bodies.end(), stands)) return;
  std::vector<std::string_view> walkers;
  for (const RobotSpec& robot : spec_.robots) {
    if (!find_entry(levels(), "level", robot.level).dynamic) walkers.emplace_back(robot.name);
  }
  if (walkers.empty()) return;
  warnings_.push_back(
      fmt::format("{}: kinematic_walking takes the ground for a plane: static bodies are walls to it, "
                  "and nobody walks onto them",
                  fmt::join(walkers, ", ")));
}

}  // namespace murosimf::scene
