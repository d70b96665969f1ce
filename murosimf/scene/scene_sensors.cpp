#include "murosimf/scene/scene_sensors.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/component_files/sensor_types.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/sensors/world_queries.h"

namespace murosimf::scene {
namespace {

/// Calls `f`; appends the name of the robot to a SetupError that it throws.
template <class F>
void about(const std::string& robot, const F& f) {
  try {
    f();
  } catch (const SetupError& error) {
    throw SetupError(fmt::format("{} (robot '{}')", error.what(), robot));
  }
}

/// Rates that do not divide the steps are refused by the sensor itself.
bool fits(const sensors::SensorSpec& spec, double step_rate) {
  try {
    sensors::check_rate(spec, step_rate);
  } catch (const SetupError&) {
    return false;
  }
  return true;
}

/// Adapts the rate of a sensor of a robot's file to the scene's steps, if steps of usual length would allow its own rate. Returns
/// the change; empty: none.
std::string fit_to_steps(sensors::SensorSpec& spec, double step_rate) {
  // a rate that steps of usual length do not allow either is an error in the file
  if (fits(spec, step_rate) || !fits(spec, usual_step_rate)) return {};
  return fmt::format("samples at {:.4g} Hz, not {:.4g}, because steps are {:.4g} ms long", step_rate,
                     std::exchange(spec.rate, step_rate), 1e3 / step_rate);
}

std::vector<sensors::SensorSpec> sensors_of(SceneParts& parts, ModelSource& models,
                                            const scene_file::RobotSpec& robot) {
  std::vector<sensors::SensorSpec> specs;
  if (!robot.sensors.none) specs = models.robot(robot).sensors;
  std::vector<SharedDiagnostic> diagnostics;
  for (sensors::SensorSpec& spec : specs)
    add_diagnostic(fit_to_steps(spec, step_rate(parts.spec, robot)), spec.name, diagnostics);
  for (const SharedDiagnostic& diagnostic : diagnostics) parts.diagnostics.note(robot.name, to_text(diagnostic));
  component_files::change_sensors(specs, robot.sensors.tables, parts.spec.file.parent_path());
  return specs;
}

/// "kinematic_walking: left_foot, right_foot: there are no ..."; empty if the level provides all quantities of the sensors.
std::string sensor_diagnostics(const SceneParts& parts, const scene_file::RobotSpec& robot) {
  const auto number =
      std::ranges::find(parts.spec.robots, robot.name, &scene_file::RobotSpec::name) - parts.spec.robots.begin();
  MUROSIMF_ASSERT(static_cast<std::size_t>(number) < parts.sensors.size());
  const LevelTraits level = parts.simulation->level_of(*parts.robots[static_cast<std::size_t>(number)])->traits();
  std::vector<SharedDiagnostic> diagnostics;
  for (const sensors::Sensor* sensor : parts.sensors[static_cast<std::size_t>(number)]) {
    add_diagnostic(sensor->diagnostic(level), sensor->reading().info->name, diagnostics);
  }
  std::string text;
  for (const SharedDiagnostic& diagnostic : diagnostics) text += (text.empty() ? "" : "; ") + to_text(diagnostic);
  return text.empty() ? "" : fmt::format("{}: {}", robot.level, text);
}

}  // namespace

/// One for all sensors: it keeps the volumes of the scene up to date in each step.
sensors::WorldQueries& shared_queries(SceneParts& parts) {
  if (!parts.queries) {
    parts.queries =
        &parts.simulation->attach<sensors::WorldQueries>("world_queries", parts.spec.rate, parts.moving_entities);
  }
  return *parts.queries;
}

void attach_sensors(SceneParts& parts, ModelSource& models, std::size_t robot) {
  MUROSIMF_ASSERT(robot < parts.robots.size() && parts.sensors.size() == robot);
  const auto view_source = [&parts] { return parts.cameras ? parts.cameras->view_source() : nullptr; };
  const auto queries = [&parts]() -> sensors::WorldQueries& { return shared_queries(parts); };
  const sensors::SensorSurroundings surroundings{parts.spec.seed, parts.moving_entities, view_source, queries};
  std::vector<const sensors::Sensor*>& attached = parts.sensors.emplace_back();
  about(parts.spec.robots[robot].name, [&] {
    for (const sensors::SensorSpec& spec : sensors_of(parts, models, parts.spec.robots[robot])) {
      attached.push_back(&component_files::attach_sensor(*parts.simulation, *parts.robots[robot], spec, surroundings,
                                                         step_rate(parts.spec, parts.spec.robots[robot])));
    }
  });
}

void note_about_sensors(SceneParts& parts) {
  std::vector<SharedDiagnostic> diagnostics;
  for (const scene_file::RobotSpec& robot : parts.spec.robots) {
    const std::string text = sensor_diagnostics(parts, robot);
    add_diagnostic(text, robot.name, diagnostics);
    (void)parts.diagnostics.is_new(robot.name, text);
  }
  for (const SharedDiagnostic& diagnostic : diagnostics) parts.diagnostics.note(to_text(diagnostic));
}

void note_about_sensors(SceneParts& parts, const scene_file::RobotSpec& robot) {
  const std::string text = sensor_diagnostics(parts, robot);
  if (!text.empty() && parts.diagnostics.is_new(robot.name, text)) parts.diagnostics.note(robot.name, text);
}

}  // namespace murosimf::scene
