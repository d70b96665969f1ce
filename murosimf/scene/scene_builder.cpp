#include "murosimf/scene/scene_builder.h"

#include <algorithm>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/body_contact.h"
#include "murosimf/control_software/tcp/tcp_server.h"
#include "murosimf/math/assert.h"
#include "murosimf/runtime/external_input_history.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/contact_marks.h"
#include "murosimf/scene/frame_completion.h"
#include "murosimf/scene/scene_algorithms.h"
#include "murosimf/scene/scene_checks.h"
#include "murosimf/scene/scene_entities.h"
#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/scene_pushing.h"
#include "murosimf/scene/scene_python.h"
#include "murosimf/scene/scene_sensors.h"
#include "murosimf/scene/scene_start.h"
#include "murosimf/scene/section_changes.h"

namespace murosimf::scene {
namespace {

/// Lets clients for unknown robots be refused at once.
void expect_software(const SceneParts& parts) {
  if (!parts.software) return;
  std::vector<std::string> robots;
  for (const scene_file::RobotSpec& robot : parts.spec.robots) {
    if (robot.controller == "tcp") robots.push_back(robot.name);
  }
  if (robots.empty()) throw SetupError("software can connect, but no robot has the controller 'tcp'");
  parts.software->expect(std::move(robots));
}

void attach_control(SceneParts& parts, ModelSource& models) {
  expect_software(parts);
  // all sensors before all controllers: a controller may read sensors of its robot only, but detectors list all entities
  for (std::size_t i = 0; i < parts.robots.size(); ++i) attach_sensors(parts, models, i);
  LoadedClasses classes = load_classes(parts);
  attach_classes(parts, classes, true);
  for (std::size_t i = 0; i < parts.robots.size(); ++i) {
    attach_controller(parts, parts.spec.robots[i], *parts.robots[i]);
  }
  attach_classes(parts, classes, false);
  for (const Entity* robot : parts.robots) attach_messages(parts, *robot);
  MUROSIMF_ASSERT(parts.sensors.size() == parts.robots.size());
}

void attach_contact(SceneParts& parts) {
  // in the order of moving_entities: ball, robots, bodies
  const scene_file::SceneSpec& spec = parts.spec;
  if (parts.ball) {
    attach_ground_contact(parts, *parts.ball, parts.ball->level, spec.ball->contact);
    attach_air(parts, *parts.ball);
  }
  for (std::size_t i = 0; i < parts.robots.size(); ++i) {
    attach_ground_contact(parts, *parts.robots[i], parts.robots[i]->level, spec.robots[i].contact,
                          spec.robots[i].contact_options);
  }
  for (Entity* body : parts.bodies) {
    attach_ground_contact(parts, *body, body->level, body->contact);
    attach_air(parts, *body);
  }
  MUROSIMF_ASSERT(parts.ground_contacts.size() == parts.moving_entities.size());
  parts.body_contact =
      &parts.simulation->attach<collision::BodyContact>("body_contact", spec.rate, parts.field, parts.moving_entities,
                                                        spec.materials,
                                                        catalog::make_body_contact_law(spec.body_contact,
                                                                                       spec.body_contact_options));
}

/// The order of attaching is the order within a step: it must not depend on the file's order of sections.
void attach_motion(SceneParts& parts) {
  if (parts.ball) attach_level(parts, *parts.ball, {});
  for (std::size_t i = 0; i < parts.robots.size(); ++i) {
    attach_level_of(parts, parts.spec.robots[i], *parts.robots[i]);
  }
  for (Entity* body : parts.bodies) {
    with_context(body_spec(parts.spec, *body)->where, [&] { attach_level(parts, *body, {}); });
  }
}

/// Observers come last: they see the result of the step.
void attach_observers(SceneParts& parts, bool paths) {
  for (Entity* entity : parts.moving_entities) attach_odometer(parts, *entity);
  for (std::size_t i = 0; i < parts.robots.size(); ++i) {
    attach_accelerations(parts, parts.spec.robots[i], *parts.robots[i]);
  }
  if (!paths) return;
  parts.recorder =
      &parts.simulation->attach<PathRecorder>("path_recorder", PathRecorder::rate_hz, parts.moving_entities);
}

}  // namespace

void build(SceneParts& parts, const SceneOptions& options) {
  Simulation& simulation = *parts.simulation;
  simulation.world().gravity = parts.spec.gravity;
  simulation.stop_if([&parts, crashes = parts.crashes, stop = options.stop] {
    crashes->check();
    control_software::crashes_of_plugins().check();
    return (stop && stop()) || !end_of_run(parts).empty();
  });
  parts.libraries = options.libraries;
  parts.files.only_from = options.files.only_from;
  parts.only_shown = options.only_shown;
  parts.software = options.software;
  parts.terminals = options.terminals;
  parts.dds_domain = options.dds_domain;
  parts.unitree_domain = options.unitree_domain;
  parts.ros2_domain = options.ros2_domain;
  parts.outside = options.outside;
  if (!parts.outside.memory) parts.outside.memory = std::make_shared<ExternalInputHistory>();
  if (options.cameras) parts.cameras = std::make_unique<CameraRenderer>(parts);
  parts.assets = options.assets ? options.assets : std::make_shared<Assets>();
  parts.lenient = options.lenient;
  ModelSource models(parts.spec, *parts.assets, options.lenient, parts.diagnostics);
  add_entities(parts, models);
  // The order of attaching is the order within a phase of the plan, and so part of the results.
  for (const Entity* robot : parts.robots) attach_multirate_stepping(parts, *robot);
  attach_control(parts, models);
  attach_pushes(parts, options.pushable);
  attach_contact(parts);
  attach_motion(parts);
  note_about_sensors(parts);
  attach_observers(parts, options.paths);
  simulation.poses().contacts_from(add_contact_marks);
  simulation.poses().complete_by(work_out_poses);
  warn_about_settings(parts);
  begin_at_every_start(parts);
  schedule_events(parts);
  parts.at_start.sections = sections_in_force(parts);
  parts.at_start.algorithms = algorithms_in_force(parts);
}

}  // namespace murosimf::scene
