#include "murosimf/scene/scene_exchange.h"

#include <algorithm>
#include <exception>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/ground_contact.h"
#include "murosimf/dynamics/servo/saturation_watch.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/dynamics/servo/torque_watch.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/constant_changes.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/robot_placement.h"
#include "murosimf/scene/scene_algorithms.h"
#include "murosimf/scene/scene_checks.h"
#include "murosimf/scene/scene_presence.h"
#include "murosimf/scene/scene_pushing.h"
#include "murosimf/scene/scene_sensors.h"
#include "murosimf/scene/scene_settings.h"
#include "murosimf/scene/section_changes.h"
#include "murosimf/scene_file/setting_targets.h"

namespace murosimf::scene {
namespace {

/// Replaces the robot's present level by that of the spec.
void renew_level(SceneParts& parts, const scene_file::RobotSpec& robot) {
  Entity& entity = parts.simulation->world().entity(robot.name);
  const catalog::LevelType& level = find_entry(catalog::levels(), "level", robot.level);
  const catalog::LevelOptions options = level_options(parts, robot);
  std::string overload = dynamics::overload_message(entity);  // both counts end with the present level
  std::string saturation = dynamics::saturation_message(entity);
  parts.simulation->exchange(robot.level, entity,
                             [&](Setup& setup) { return catalog::make_level(robot.level, setup, options); });
  if (!overload.empty()) parts.diagnostics.warn(std::move(overload));
  if (!saturation.empty()) parts.diagnostics.note(std::move(saturation));
  entity.contact = level.traits.dynamic ? robot.contact : "";
  warn_about_level(parts, robot);
  note_about_sensors(parts, robot);
}

/// Options of a robot's contact law; none for ball and bodies.
OptionValues contact_options(const SceneParts& parts, std::string_view entity) {
  for (const scene_file::RobotSpec& robot : parts.spec.robots) {
    if (robot.name == entity) return robot.contact_options;
  }
  return {};
}

std::size_t number_of(const SceneParts& parts, std::string_view entity) {
  const auto found = std::ranges::find(parts.moving_entities, &parts.simulation->world().entity(entity));
  if (found == parts.moving_entities.end()) {
    throw SetupError(fmt::format("'{}' does not move; it has no contact law", entity));
  }
  return static_cast<std::size_t>(found - parts.moving_entities.begin());
}

void put(SceneParts& parts, const Placement& placement, const std::string& entity) {
  place(parts, entity, placement);
  const Vec3d& r = placement.position;
  parts.simulation->record(
      fmt::format("{}: placed at {:g}, {:g}, {:g} m, heading {:g} rad", entity, r.x, r.y, r.z, placement.heading));
}

/// Index among the motions of the robot's file. Throws SetupError for an unknown name, and for robots without a motion engine.
std::size_t motion_number(const Entity& robot, std::string_view motion) {
  const locomotion::NamedMotions* motions = robot.model().find(properties::given_motions, 0);
  if (!robot.find(properties::motion_request)) {
    throw SetupError(
        fmt::format("'{}' has no motion engine that could play '{}'; its controller would have to be \"motions\"",
                    robot.name(), motion));
  }
  std::vector<std::string_view> names;
  for (std::size_t i = 0; motions && i < motions->size(); ++i) {
    if ((*motions)[i].name == motion) return i;
    names.emplace_back((*motions)[i].name);
  }
  throw SetupError(fmt::format("'{}': {}", robot.name(), unknown_name("motion", motion, names)));
}

/// Requests a motion, which the engine plays as soon as it can (locomotion/motion_engine.h).
void play_motion(SceneParts& parts, const std::string& robot, std::string_view motion) {
  Entity& entity = parts.simulation->world().entity(robot);
  locomotion::MotionRequests requests = entity.base().get(properties::motion_request);
  // a counter, not a flag: requests in one step are distinguished from repeated values
  requests.number[motion_number(entity, motion)] += 1;
  entity.base().set(properties::motion_request, requests);
  parts.simulation->record(fmt::format("{}: is asked for {}", robot, motion));
}

/// Throws SetupError for robots without a motion engine, or without a kick among their motions.
void check_kick(const Entity& robot) {
  if (!robot.find(properties::kick_request)) {
    throw SetupError(
        fmt::format("'{}' has no motion engine that could kick; its controller would have to be \"motions\"",
                    robot.name()));
  }
  const locomotion::NamedMotions* motions = robot.model().find(properties::given_motions, 0);
  if (!motions || !locomotion::has_kick(*motions)) {
    throw SetupError(fmt::format("'{}': no motion of its file says where it kicks a ball (key 'kick', docs/motions.md)",
                                 robot.name()));
  }
}

/// A new number marks a new request: the same kick may be requested twice.
void kick(SceneParts& parts, const std::string& robot, locomotion::KickRequest request) {
  Entity& entity = parts.simulation->world().entity(robot);
  check_kick(entity);
  request.number = entity.base().get(properties::kick_request).number + 1;
  entity.base().set(properties::kick_request, request);
  parts.simulation->record(fmt::format("{}: is asked for a kick to {:g} rad", robot, request.direction));
}

void apply(SceneParts& parts, const scene_file::SceneEvent& event, const std::string& entity) {
  with_context(event.where, [&] {
    if (event.setting && is_constant(*event.setting)) return change_constant(parts, *event.setting, entity);
    if (event.setting) return apply(parts, *event.setting, entity);
    if (event.push) return push(parts, *event.push, entity);
    if (event.place) return put(parts, *event.place, entity);
    if (event.key == "level") return exchange_level(parts, entity, event.value);
    if (event.key == "contact") return exchange_contact(parts, entity, event.value);
    if (event.key == "play") return play_motion(parts, entity, event.value);
    if (event.kick) return kick(parts, entity, *event.kick);
    if (event.key == "present") return event.value == "true" ? enter(parts, entity) : leave(parts, entity);
    exchange_servo_law(parts, entity, event.value);
  });
}

/// Throws SetupError for objects that the entity does not have, and for constants that it cannot have.
void check_setting_of(const SceneParts& parts, const scene_file::SceneEvent& event, const std::string& entity) {
  const Model& model = parts.simulation->world().entity(entity).model();
  with_context(event.where, [&] {
    if (is_constant(*event.setting)) return check_constant(parts, *event.setting, entity);
    (void)scene_file::objects_meant(model, event.setting->object, event.setting->property);
  });
}

Algorithms algorithms_of(const SceneParts& parts, const Entity& entity) {
  const auto& robots = parts.spec.robots;
  const auto robot = std::ranges::find(robots, entity.name(), &scene_file::RobotSpec::name);
  if (robot == robots.end()) return {.contact = entity.contact};
  return {robot->level, robot->servo_law, robot->contact};
}

}  // namespace

void exchange_level(SceneParts& parts, std::string_view robot, std::string_view level) {
  scene_file::RobotSpec& spec = robot_spec(parts.spec, robot);
  // the spec is changed last: a level that throws leaves it as it was
  scene_file::RobotSpec changed = spec;
  changed.level = find_entry(catalog::levels(), "level", level).name;
  renew_level(parts, changed);
  if (changed.level == spec.level) parts.simulation->record(fmt::format("{}: {}, as before", robot, level));
  spec = std::move(changed);
}

void exchange_servo_law(SceneParts& parts, std::string_view robot, std::string_view law) {
  scene_file::RobotSpec& spec = robot_spec(parts.spec, robot);
  scene_file::RobotSpec changed = spec;
  changed.servo_law = find_entry(dynamics::servo_laws(), "servo law", law).name;
  if (find_entry(catalog::levels(), "level", spec.level).traits.servos) renew_level(parts, changed);
  parts.simulation->record(fmt::format("{}: servo law {}", robot, law));
  spec = std::move(changed);
}

void exchange_contact(SceneParts& parts, std::string_view entity, std::string_view law) {
  const std::size_t number = number_of(parts, entity);
  Entity& changed = *parts.moving_entities[number];
  MUROSIMF_ASSERT(number < parts.ground_contacts.size());
  parts.ground_contacts[number]->exchange_law(catalog::make_contact_law(law, contact_options(parts, entity)));
  parts.simulation->record(fmt::format("{}: contact {}", entity, law));
  if (std::ranges::find(parts.robots, &changed) ==
      parts.robots.end()) {  // ball and bodies are always at a level with forces
    if (&changed == parts.ball) parts.spec.ball->contact = law;
    changed.contact = law;
    return;
  }
  scene_file::RobotSpec& robot = robot_spec(parts.spec, entity);
  robot.contact = law;
  if (find_entry(catalog::levels(), "level", robot.level).traits.dynamic) changed.contact = law;
  warn_about_level(parts, robot);
}

std::vector<Algorithms> algorithms_in_force(const SceneParts& parts) {
  std::vector<Algorithms> all;
  for (const Entity* entity : parts.moving_entities) all.push_back(algorithms_of(parts, *entity));
  MUROSIMF_ASSERT(all.size() == parts.moving_entities.size());
  return all;
}

/// Only what differs is exchanged: an exchange resets the memory of an algorithm.
void put_in_force(SceneParts& parts, Entity& entity, const Algorithms& algorithms) {
  const Algorithms present = algorithms_of(parts, entity);
  if (algorithms.contact != present.contact) {
    parts.ground_contacts[number_of(parts, entity.name())]->exchange_law(
        catalog::make_contact_law(algorithms.contact, contact_options(parts, entity.name())));
    if (&entity == parts.ball) parts.spec.ball->contact = algorithms.contact;
  }
  entity.contact = algorithms.contact;
  if (present.level.empty()) return;
  scene_file::RobotSpec& robot = robot_spec(parts.spec, entity.name());
  scene_file::RobotSpec changed = robot;
  changed.contact = algorithms.contact;
  changed.level = find_entry(catalog::levels(), "level", algorithms.level).name;
  changed.servo_law = algorithms.servo_law;
  if (changed.level != robot.level || changed.servo_law != robot.servo_law) {
    const catalog::LevelOptions options = level_options(parts, changed);
    const auto make = [&](Setup& setup) { return catalog::make_level(changed.level, setup, options); };
    parts.simulation->exchange(changed.level, entity, make, LevelStart::anew);
  }
  if (!find_entry(catalog::levels(), "level", changed.level).traits.dynamic) entity.contact.clear();
  robot = std::move(changed);
}

/// All entities are checked before the first one is changed.
void check_change(const SceneParts& parts, const scene_file::SceneEvent& change) {
  if (!change.section.empty()) return check_section_change(parts, change);
  if (change.push) {
    for (const std::string& entity : change.entities) {
      with_context(change.where, [&] { check_push(parts, *change.push, entity); });
    }
  }
  if (change.key == "play") {
    for (const std::string& entity : change.entities)
      with_context(change.where, [&] { (void)motion_number(parts.simulation->world().entity(entity), change.value); });
  }
  if (change.kick) {
    for (const std::string& entity : change.entities)
      with_context(change.where, [&] { check_kick(parts.simulation->world().entity(entity)); });
  }
  if (!change.setting) return;
  for (const std::string& entity : change.entities) {
    check_setting_of(parts, change, entity);
  }
}

/// The first error is reported after all others have had their change.
void apply_change(SceneParts& parts, const scene_file::SceneEvent& change) {
  if (!change.section.empty()) return apply_section_change(parts, change);
  std::exception_ptr first;
  for (const std::string& entity : change.entities) {
    try {
      apply(parts, change, entity);
    } catch (const SetupError&) {
      if (!first) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
}

void schedule_events(SceneParts& parts) {
  for (const scene_file::SceneEvent& event : parts.spec.events) {
    check_change(parts, event);
    if (!event.section.empty()) {
      parts.simulation->at(from_seconds(event.time), [&parts, &event] { apply_section_change(parts, event); });
    }
    for (const std::string& entity : event.entities) {
      // one call per entity: an error of one does not keep the others from changing
      parts.simulation->at(from_seconds(event.time), [&parts, &event, &entity] { apply(parts, event, entity); });
    }
  }
}

}  // namespace murosimf::scene
