#include "murosimf/scene/scene_algorithms.h"

#include <fmt/format.h>

#include "murosimf/air/air.h"
#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/ground_contact.h"
#include "murosimf/collision/multirate_stepping.h"
#include "murosimf/control_software/message_exchange.h"
#include "murosimf/dynamics/accelerations.h"
#include "murosimf/dynamics/odometer.h"
#include "murosimf/math/assert.h"
#include "murosimf/robot/motion_file.h"
#include "murosimf/scene/scene_checks.h"
#include "murosimf/scene/scene_python.h"
#include "murosimf/scene_file/field.h"
#include "murosimf/scene_file/level_options.h"

namespace murosimf::scene {
namespace {

catalog::ControllerOptions controller_options(const SceneParts& parts, const scene_file::RobotSpec& robot) {
  const scene_file::SceneSpec& spec = parts.spec;
  catalog::ControllerOptions options;
  options.moving_entities = parts.moving_entities;
  options.command = robot.command;
  options.own = robot.options;
  options.rate = robot.control_rate;
  options.library = robot.library;
  options.call_budget = robot.call_budget;
  options.reload = robot.reload;
  options.link = robot.link;
  options.crashes = parts.crashes;
  options.software = parts.software;
  options.folder = spec.file.parent_path();
  options.terminals = parts.terminals;
  options.dds_domain = parts.dds_domain;
  options.unitree_domain = parts.unitree_domain;
  options.ros2_domain = parts.ros2_domain;
  options.outside = parts.outside;
  const scene_file::FieldSize& field = scene_file::field_size(spec.field.size);
  options.half_field = {0.5 * field.length, 0.5 * field.width, 0};
  options.start = {robot.position.x, robot.position.y, robot.heading};
  options.markings = scene_file::field_markings(field, spec.field.goals);
  options.seed = spec.seed;
  for (const scene_file::TeamSpec& team : spec.teams) {
    if (team.name == robot.team) options.attacks = team.attacks;
  }
  if (!robot.motion.empty()) {
    options.motion = with_context(robot.where, [&] {
      return robot::read_motion(robot::find_motion(robot.motion, spec.file.parent_path()));
    });
  }
  return options;
}

/// What of others a robot has loaded, a library or a class in Python; empty: nothing.
std::string software_of(const scene_file::RobotSpec& robot) {
  if (robot.controller != "python") return robot.library;
  const auto named = robot.options.find("class");
  return named == robot.options.end() ? std::string() : value_text(named->second);
}

void refuse_software_of_file(const SceneParts& parts, const scene_file::RobotSpec& robot) {
  const std::string software = software_of(robot);
  if (software.empty()) return;
  const bool of_python = robot.controller == "python";
  const auto given = robot.given.find(of_python ? "options.class" : "library");
  if (given == robot.given.end() && !of_python) return;  // a program has named it
  const std::string where = given == robot.given.end() ? robot.where : given->second.where;
  refuse_software_of_file(parts, where, software);
}

}  // namespace

/// A run that is only shown takes positions from a recording: no software is started.
void attach_controller(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity) {
  const bool from_outside = robot.controller == "library" || robot.controller == "python" ||
                            robot.controller == "serial" || robot.controller == "tcp" ||
                            robot.controller == "booster" || robot.controller == "unitree" ||
                            robot.controller == "ros2";
  if (parts.only_shown && from_outside) return;
  refuse_software_of_file(parts, robot);
  const catalog::ControllerOptions options = controller_options(parts, robot);
  const catalog::ControllerType& controller = find_entry(catalog::controllers(), "controller", robot.controller);
  with_context(robot.where, [&] { controller.attach(*parts.simulation, entity, options); });
}

void attach_messages(SceneParts& parts, const Entity& entity) {
  if (parts.messages || !entity.find(control_software::message_box)) return;
  parts.messages =
      &parts.simulation->attach<control_software::MessageExchange>("message_exchange", parts.spec.rate, parts.robots,
                                                                   parts.spec.communication, parts.spec.seed);
}

void attach_ground_contact(SceneParts& parts, Entity& entity, const std::string& level, const std::string& law,
                           const OptionValues& options) {
  if (find_entry(catalog::levels(), "level", level).traits.dynamic) entity.contact = law;
  parts.ground_contacts.push_back(
      &parts.simulation->attach<collision::GroundContact>("ground_contact", entity, parts.spec.rate, parts.field,
                                                          catalog::make_contact_law(law, options),
                                                          parts.spec.materials));
}

void attach_air(SceneParts& parts, Entity& entity) {
  if (parts.spec.air.density == 0 || !air::feels_air(entity.model())) return;
  parts.simulation->attach<air::Air>("air", entity, parts.spec.rate, parts.spec.air);
}

catalog::LevelOptions level_options(const SceneParts& parts, const scene_file::RobotSpec& robot) {
  catalog::LevelOptions options = scene_file::level_options(robot);
  options.environment = parts.field;
  return options;
}

void attach_level(SceneParts& parts, Entity& entity, const catalog::LevelOptions& options) {
  MUROSIMF_ASSERT(parts.spec.rate > 0);
  parts.simulation->attach(entity.level, entity, parts.spec.rate,
                           [&](Setup& setup) { return catalog::make_level(entity.level, setup, options); });
}

void attach_level_of(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity) {
  warn_about_level(parts, robot);
  with_context(robot.where, [&] { attach_level(parts, entity, level_options(parts, robot)); });
}

void attach_multirate_stepping(SceneParts& parts, const Entity& entity) {
  if (parts.multirate_stepping || entity.options().step_multiple == 1) return;
  parts.multirate_stepping =
      &parts.simulation->attach<collision::MultirateStepping>("step_multiple", parts.spec.rate, parts.moving_entities);
}

void attach_odometer(SceneParts& parts, Entity& entity) {
  parts.simulation->attach<dynamics::Odometer>("odometer", entity, dynamics::Odometer::rate_hz);
}

void attach_accelerations(SceneParts& parts, const scene_file::RobotSpec& robot, Entity& entity) {
  if (!robot.accelerations) return;
  parts.simulation->attach<dynamics::Accelerations>("accelerations", entity, step_rate(parts.spec, robot));
}

}  // namespace murosimf::scene
