#include "murosimf/viewer/inspection.h"

#include <algorithm>
#include <cmath>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/odometer.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/soccer/beliefs.h"

namespace murosimf::viewer {
namespace {

template <class T>
std::optional<T> base_value(const Entity& entity, const Property<T>& property) {
  const Column<T>* column = entity.find(property);
  return column && !column->values.empty() ? std::optional<T>(column->values[0]) : std::nullopt;
}

EntityState state_of(const scene::SceneParts& parts, const Entity& entity) {
  EntityState state{.name = entity.name(),
                    .level = entity.level,
                    .contact = entity.contact,
                    .controller = entity.controller};
  state.is_robot = std::ranges::find(parts.robots, &entity) != parts.robots.end();
  state.moves = std::ranges::find(parts.moving_entities, &entity) != parts.moving_entities.end();
  state.present = entity.present();
  state.frozen = entity.frozen();
  if (base_value(entity, properties::dynamic) == 0.0) {
    if (const auto foot = base_value(entity, properties::stance_foot)) state.standing_foot = *foot != 0 ? 1 : 0;
  }
  state.believed_pose = soccer::believed_pose(entity);
  state.falls = dynamics::way_and_falls(entity).falls;
  return state;
}

ObjectValues values_of(const World& world, const ObjectPath& path, const std::vector<std::string>& known) {
  ObjectValues values{path, {}};
  if (path.entity < 0 || path.entity >= static_cast<int>(world.entities().size())) return values;
  Entity& entity = *world.entities()[static_cast<std::size_t>(path.entity)];
  if (path.object < 0 || path.object >= entity.model().size()) return values;
  const ObjectAccess object(entity, path.object);
  for (const std::string_view name : object.properties()) {
    const bool shown = known.empty() || !entity.find(name) || std::ranges::find(known, name) != known.end();
    if (!shown) continue;
    try {
      const Quantity quantity = object.get(name);
      values.properties.push_back(
          {std::string(name), std::string(quantity.unit), quantity.numbers, entity.find(name) == nullptr});
    } catch (const SetupError&) {  // properties that are no row of numbers are not shown
    }
  }
  return values;
}

SensorState state_of(const sensors::Reading& reading) {
  return {reading.info, seconds(reading.time), reading.samples, reading.values};
}

CameraState state_of(const sensors::CameraFrame& frame, bool with_picture) {
  CameraState state{frame.info, frame.wanted, seconds(frame.time), {}};
  if (with_picture && frame.number > 0) state.picture = frame.color;
  return state;
}

/// Only levels with torques have loads.
void add_loads(const scene::SceneParts& parts, const World& world, std::vector<JointLoad>& loads) {
  for (std::size_t i = 0; i < world.entities().size(); ++i) {
    const Entity& entity = *world.entities()[i];
    const Column<double>* torque = entity.find(properties::joint_torque);
    if (!torque || !entity.present() || std::ranges::find(parts.robots, &entity) == parts.robots.end()) continue;
    for (const int object : entity.model().having(properties::servo)) {
      const Servo& servo = *entity.model().find(properties::servo, object);
      const double limit = servo.torque_limit > 0 ? servo.torque_limit : servo.stall_torque;
      if (!(limit > 0)) continue;
      loads.push_back(
          {{static_cast<int>(i), object}, std::abs(torque->values[static_cast<std::size_t>(object)]) / limit});
      MUROSIMF_ASSERT(static_cast<std::size_t>(object) < torque->values.size());
    }
  }
}

template <class T>
std::size_t copy_from(std::size_t known, const std::vector<T>& all, std::vector<T>& into) {
  const std::size_t first = std::min(known, all.size());
  MUROSIMF_ASSERT(first <= all.size());
  into.assign(all.begin() + static_cast<std::ptrdiff_t>(first), all.end());
  return first;
}

}  // namespace

/// Only what was requested is read: the thread of the run waits meanwhile.
Inspection inspect(const scene::Scene& scene, const InspectionRequest& request) {
  const Simulation& simulation = scene.simulation();
  const scene::SceneParts& parts = scene.parts();
  const World& world = simulation.world();
  Inspection seen{.time = simulation.now(), .changes_to_see = parts.changes_to_see};
  for (const auto& entity : world.entities()) seen.entities.push_back(state_of(parts, *entity));
  for (const ObjectPath& path : request.objects) seen.objects.push_back(values_of(world, path, request.properties));
  seen.sensors_of = request.sensors_of;
  if (request.sensors_of && *request.sensors_of < static_cast<int>(world.entities().size())) {
    const Entity& entity = *world.entities()[static_cast<std::size_t>(*request.sensors_of)];
    for (const sensors::Reading* reading : sensors::readings_of(entity)) seen.sensors.push_back(state_of(*reading));
    for (const sensors::CameraFrame* frame : sensors::frames_of(entity)) {
      seen.cameras.push_back(state_of(*frame, request.pictures));
    }
  }
  if (request.algorithms) seen.algorithms = simulation.statistics();
  if (request.loads) add_loads(parts, world, seen.loads);
  seen.drawings = drawing::drawn_changes(world);
  if (seen.drawings != request.drawings_known) seen.drawn = drawing::drawn_by_robots(world);
  seen.first_event = copy_from(request.events_known, simulation.events(), seen.events);
  std::vector<std::string> warnings = parts.diagnostics.warnings();
  warnings.insert(warnings.end(), simulation.warnings().begin(), simulation.warnings().end());
  seen.first_warning = copy_from(request.warnings_known, warnings, seen.warnings);
  return seen;
}

/// Everything about entities that does not change between two scenes.
std::vector<EntityOutline> outline_of(const scene::Scene& scene) {
  const scene::SceneParts& parts = scene.parts();
  std::vector<EntityOutline> all;
  for (const auto& entity : scene.simulation().world().entities()) {
    EntityOutline outline{.name = entity->name(), .model = entity->model_ptr(), .color = entity->options().color};
    const auto robot = std::ranges::find(parts.robots, entity.get());
    outline.is_robot = robot != parts.robots.end();
    if (outline.is_robot) outline.label = static_cast<int>(robot - parts.robots.begin());
    outline.is_ball = entity.get() == parts.ball;
    outline.moves = std::ranges::find(parts.moving_entities, entity.get()) != parts.moving_entities.end();
    for (const scene_file::RobotSpec& spec : scene.spec().robots) {
      if (spec.name == outline.name) outline.team = spec.team;
    }
    all.push_back(std::move(outline));
  }
  return all;
}

}  // namespace murosimf::viewer
