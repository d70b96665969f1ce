#include "murosimf/scene/scene_addition.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene_algorithms.h"
#include "murosimf/scene/scene_checks.h"
#include "murosimf/scene/scene_entities.h"
#include "murosimf/scene/scene_exchange.h"
#include "murosimf/scene/scene_sensors.h"
#include "murosimf/scene/scene_start.h"
#include "murosimf/scene/section_changes.h"
#include "murosimf/scene/start_overlaps.h"

namespace murosimf::scene {
namespace {

/// Truncates all lists of the scene to their former length, unless done() was called.
class Lengths {
 public:
  explicit Lengths(SceneParts& parts) : parts_(parts) {}
  Lengths(const Lengths&) = delete;
  Lengths& operator=(const Lengths&) = delete;
  ~Lengths() {
    if (!done_) shorten();
  }
  void done() { done_ = true; }

  /// Undoes an addition that failed half-way: lists are as long as before.
 private:
  void shorten() {
    MUROSIMF_ASSERT(parts_.robots.size() >= robots_ && parts_.moving_entities.size() >= moving_);
    parts_.spec.robots.resize(robots_);
    parts_.spec.bodies.resize(bodies_);
    parts_.robots.resize(robots_);
    parts_.sensors.resize(robots_);
    parts_.bodies.resize(moving_bodies_);
    parts_.moving_entities.resize(moving_);
    parts_.ground_contacts.resize(moving_);
    parts_.queries = queries_;
    parts_.multirate_stepping = multirate_;
    parts_.messages = messages_;
  }

  SceneParts& parts_;
  std::size_t robots_ = parts_.spec.robots.size(), bodies_ = parts_.spec.bodies.size();
  std::size_t moving_bodies_ = parts_.bodies.size(), moving_ = parts_.moving_entities.size();
  sensors::WorldQueries* queries_ = parts_.queries;                      // may have been attached with its sensors
  collision::MultirateStepping* multirate_ = parts_.multirate_stepping;  // may have been attached with it
  control_software::MessageExchange* messages_ = parts_.messages;        // the same
  bool done_ = false;
};

void check_team(const scene_file::SceneSpec& spec, const scene_file::RobotSpec& robot) {
  if (robot.team.empty()) return;
  std::vector<std::string_view> names;
  for (const scene_file::TeamSpec& team : spec.teams) names.push_back(team.name);
  if (std::ranges::find(names, robot.team) == names.end()) throw SetupError(unknown_name("team", robot.team, names));
}

/// Files are noted apart from those of the scene: a recording takes them when they come.
files::FileAccess access_of(const SceneParts& parts) {
  files::FileAccess access = parts.files;
  access.noted = parts.files_of_additions;
  return access;
}

/// Final steps for robots and bodies.
void finish(SceneParts& parts, Entity& entity, Addition addition) {
  parts.additions.push_back(std::move(addition));
  start_moving(parts, entity);
  parts.at_start.algorithms.push_back(algorithms_in_force(parts).back());
  show_changes(parts);
  MUROSIMF_ASSERT(parts.at_start.algorithms.size() == parts.moving_entities.size());
  parts.diagnostics.warn(overlaps_of(entity, *parts.field, parts.moving_entities));
}

}  // namespace

Entity& add(SceneParts& parts, scene_file::RobotSpec robot) {
  const files::FileScope scope(access_of(parts));
  parts.simulation->initialize();
  check_team(parts.spec, robot);
  ModelSource models(parts.spec, *parts.assets, parts.lenient, parts.diagnostics);
  const EntitySpec kind = robot_entity(parts, models, robot);
  Lengths lengths(parts);
  parts.spec.robots.push_back(robot);
  // The same order of algorithms within an entity as in scene_builder.cpp: waves follow the order of attaching.
  const auto furnish = [&](Entity& entity) {
    enlist(parts, robot, entity);
    attach_multirate_stepping(parts, entity);
    attach_sensors(parts, models, parts.robots.size() - 1);
    attach_controller(parts, robot, entity);
    attach_messages(parts, entity);
    attach_ground_contact(parts, entity, robot.level, robot.contact, robot.contact_options);
    attach_level_of(parts, robot, entity);
    attach_odometer(parts, entity);
    attach_accelerations(parts, robot, entity);
  };
  const auto prepare = [&](Entity& entity) { place_at_start(parts, entity); };
  Entity& entity = parts.simulation->add(robot.name, kind.model, kind.options, furnish, prepare);
  lengths.done();
  note_about_sensors(parts, robot);
  finish(parts, entity, {parts.simulation->now(), std::move(robot)});
  return entity;
}

/// An addition that fails is undone by `lengths`.
Entity& add(SceneParts& parts, scene_file::BodySpec body) {
  if (body.is_static)
    throw SetupError(fmt::format("'{}' is static: it is part of the field from the start", body.name));
  const files::FileScope scope(access_of(parts));
  parts.simulation->initialize();
  ModelSource models(parts.spec, *parts.assets, parts.lenient, parts.diagnostics);
  const EntitySpec kind = body_entity(models, body);
  Lengths lengths(parts);
  parts.spec.bodies.push_back(body);
  const auto furnish = [&](Entity& entity) {
    enlist(parts, body, entity);
    attach_ground_contact(parts, entity, entity.level, body.contact);
    attach_air(parts, entity);
    attach_level(parts, entity, {});
    attach_odometer(parts, entity);
  };
  Entity& entity = parts.simulation->add(body.name, kind.model, kind.options, furnish);
  lengths.done();
  finish(parts, entity, {parts.simulation->now(), std::move(body)});
  return entity;
}

}  // namespace murosimf::scene
