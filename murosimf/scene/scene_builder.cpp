#include "murosimf/scene/scene_builder.h"

#include <algorithm>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/body_contact.h"
#include "murosimf/collision/ground_contact.h"
#include "murosimf/motion/odometer.h"
#include "murosimf/scene/contact_marks.h"
#include "murosimf/scene/scene_checks.h"
#include "murosimf/scene/scene_entities.h"
#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/scene_pushing.h"
#include "murosimf/scene/scene_sensors.h"
#include "murosimf/scene/scene_start.h"
#include "murosimf/scene_file/field.h"
#include "murosimf/scene_file/level_options.h"
#include "murosimf/scene_file/motion_file.h"

namespace murosimf::scene {
namespace {

catalog::ControllerOptions controller_options(const SceneParts& parts, const scene_file::RobotSpec& robot) {
  const scene_file::SceneSpec& spec = parts.spec;
  catalog::ControllerOptions options;
  options.everybody = parts.moving_entities;
  options.command = robot.command;
  options.own = robot.options;
  const scene_file::FieldSize& field = scene_file::field_size(spec.field.size);
  options.half_field = {0.5 * field.length, 0.5 * field.width, 0};
  options.start = {robot.position.x, robot.position.y, robot.heading};
  options.markings = scene_file::field_markings(field);
  options.seed = spec.seed;
  for (const scene_file::TeamSpec& team : spec.teams) {
    if (team.name == robot.team) options.attacks = team.attacks;
  }
  if (!robot.motion.empty()) {
    options.motion = with_context(robot.where, [&] {
      return scene_file::read_motion(scene_file::find_motion(robot.motion, spec.file.parent_path()));
    });
  }
  return options;
}

void attach_controllers(SceneParts& parts) {
  for (std::size_t i = 0; i < parts.robots.size(); ++i) {
    const scene_file::RobotSpec& robot = parts.spec.robots[i];
    const catalog::ControllerOptions options = controller_options(parts, robot);
    const catalog::ControllerType& controller = find_entry(catalog::controllers(), "controller", robot.controller);
    with_context(robot.where, [&] { controller.attach(*parts.simulation, *parts.robots[i], options); });
  }
}

/// Also for those whom no force moves: they may change their level.
void attach_ground_contact(SceneParts& parts, Entity& entity, const std::string& level, const std::string& law,
                           const OptionValues& options = {}) {
  if (find_entry(catalog::levels(), "level", level).traits.dynamic) entity.contact = law;
  parts.ground_contacts.push_back(
      &parts.simulation->attach<collision::GroundContact>("ground_contact", entity, parts.spec.rate, parts.field,
                                                          catalog::make_contact_law(law, options),
                                                          parts.spec.materials));
}

void attach_contact(SceneParts& parts) {
  const scene_file::SceneSpec& spec = parts.spec;
  if (parts.ball) attach_ground_contact(parts, *parts.ball, parts.ball->level, spec.ball->contact);
  for (std::size_t i = 0; i < parts.robots.size(); ++i) {
    attach_ground_contact(parts, *parts.robots[i], parts.robots[i]->level, spec.robots[i].contact,
                          spec.robots[i].contact_options);
  }
  for (Entity* body : parts.bodies) attach_ground_contact(parts, *body, body->level, body->contact);
  parts.simulation->attach<collision::BodyContact>("body_contact", *parts.field, spec.rate, parts.moving_entities,
                                                   spec.materials,
                                                   catalog::make_body_contact_law(spec.body_contact,
                                                                                  spec.body_contact_options));
}

void attach_level(SceneParts& parts, Entity& entity, const catalog::LevelOptions& options) {
  parts.simulation->attach(entity.level, entity, parts.spec.rate,
                           [&](Setup& setup) { return catalog::make_level(entity.level, setup, options); });
}

void attach_motion(SceneParts& parts) {
  if (parts.ball) attach_level(parts, *parts.ball, {});
  for (std::size_t i = 0; i < parts.robots.size(); ++i) {
    const scene_file::RobotSpec& robot = parts.spec.robots[i];
    warn_about_level(parts, robot);
    with_context(robot.where, [&] { attach_level(parts, *parts.robots[i], scene_file::level_options(robot)); });
  }
  for (Entity* body : parts.bodies) {
    with_context(body_spec(parts.spec, *body)->where, [&] { attach_level(parts, *body, {}); });
  }
}

void attach_observers(SceneParts& parts, bool paths) {
  for (Entity* entity : parts.moving_entities) {
    parts.simulation->attach<motion::Odometer>("odometer", *entity, motion::Odometer::rate_hz);
  }
  if (!paths) return;
  parts.recorder = &parts.simulation->attach<PathRecorder>("path_recorder", *parts.field, PathRecorder::rate_hz,
                                                           parts.moving_entities);
}

}  // namespace

void build(SceneParts& parts, const SceneOptions& options) {
  Simulation& simulation = *parts.simulation;
  simulation.world().gravity = parts.spec.gravity;
  simulation.stop_if(options.stop);
  if (options.cameras) parts.cameras = std::make_unique<CameraRenderer>(parts);
  const std::shared_ptr<Assets> assets = options.assets ? options.assets : std::make_shared<Assets>();
  ModelSource models(parts.spec, *assets, options.lenient, parts.remarks);
  add_entities(parts, models);
  attach_sensors(parts, models);
  attach_controllers(parts);
  attach_pushes(parts);
  attach_contact(parts);
  attach_motion(parts);
  note_about_sensors(parts);
  warn_about_static_bodies(parts);
  attach_observers(parts, options.paths);
  simulation.poses().contacts_from(add_contact_marks);
  warn_about_settings(parts);
  begin_at_every_start(parts);
  schedule_events(parts);
  parts.at_start.algorithms = algorithms_in_force(parts);
}

}  // namespace murosimf::scene
