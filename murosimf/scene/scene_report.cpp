#include "murosimf/scene/scene_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/dynamics/odometer.h"
#include "murosimf/dynamics/servo/saturation_watch.h"
#include "murosimf/dynamics/servo/torque_watch.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/interpenetration_warnings.h"
#include "murosimf/scene/scene_python.h"
#include "murosimf/scene/unsettled_warning.h"

namespace murosimf::scene {
namespace {

EntityReport report_of(Entity& entity) {
  const auto base = entity.base();
  const dynamics::WayAndFalls counted = dynamics::way_and_falls(entity);
  return {entity.name(),         entity.model().name(),          entity.level,   entity.contact, entity.controller,
          entity.options().team, base.get(properties::position), counted.walked, counted.falls,  entity.frozen(),
          entity.present()};
}

void add_control_warnings(const Scene& scene, std::vector<std::string>& lines) {
  for (const Entity* entity : scene.moving_entities()) {
    const control_software::SoftwareReport* software = control_software::software_report(*entity);
    if (!software) continue;
    if (!software->ended.empty()) {
      lines.push_back(fmt::format("{}: its control software has ended {}", entity->name(), software->ended));
    }
    for (const auto& changed : software->changed) {
      lines.push_back(fmt::format("{}: its control software has changed {}, {} times, first at {:.3f} s; put back",
                                  entity->name(), changed.what, changed.times, seconds(changed.first)));
    }
    if (software->refused > 0) {
      lines.push_back(fmt::format("{}: {} numbers of its control software were refused, the first {}", entity->name(),
                                  software->refused, software->first_refusal));
    }
    if (software->messages && software->messages->refused > 0) {
      lines.push_back(fmt::format("{}: {} messages of its control software were refused, the first {}", entity->name(),
                                  software->messages->refused, software->first_refused_message));
    }
  }
}

void add_algorithm_warnings(const Scene& scene, std::vector<std::string>& lines) {
  for (const auto* algorithm : scene.parts().algorithms) {
    if (algorithm->report().ended.empty() || !algorithm->end_of_run().empty()) continue;
    lines.push_back(fmt::format("{}: it has ended {}", algorithm->name(), algorithm->report().ended));
  }
}

/// Notes of the scene, then those of the run.
std::vector<std::string> notes_of(const Scene& scene) {
  std::vector<std::string> all = scene.parts().diagnostics.notes();
  for (const Entity* entity : scene.moving_entities()) {
    if (auto line = dynamics::saturation_message(*entity); !line.empty()) all.push_back(std::move(line));
  }
  return all;
}

/// Warnings, likewise.
std::vector<std::string> warnings_of(const Scene& scene, const Lateness& lateness) {
  std::vector<std::string> all = scene.parts().diagnostics.warnings();
  const auto& frozen = scene.simulation().warnings();
  all.insert(all.end(), frozen.begin(), frozen.end());
  if (auto line = events_to_come(scene); !line.empty()) all.push_back(std::move(line));
  for (const Entity* entity : scene.moving_entities()) {
    if (auto line = dynamics::overload_message(*entity); !line.empty()) all.push_back(std::move(line));
  }
  for (auto& line : interpenetration_warnings(scene.simulation().world())) all.push_back(std::move(line));
  if (auto line = unsettled_warning(scene.simulation().world()); !line.empty()) all.push_back(std::move(line));
  add_control_warnings(scene, all);
  add_algorithm_warnings(scene, all);
  if (lateness.late_steps > 0) all.push_back(to_text(lateness));
  return all;
}

}  // namespace

std::string to_text(const Lateness& lateness) {
  return fmt::format("late: {} of {} steps ended behind schedule, the worst {:.1f} ms", lateness.late_steps,
                     lateness.steps, 1e3 * seconds(lateness.worst));
}

RunReport make_report(const Scene& scene, Duration wall, const Lateness& lateness) {
  const Simulation& simulation = scene.simulation();
  RunReport report;
  report.scene = scene.spec().name;
  report.simulated = seconds(simulation.now());
  report.wall = seconds(wall);
  report.real_time_factor = wall > Duration{} ? report.simulated / report.wall : 0;
  report.threads = simulation.pool().threads();
  report.seed = scene.spec().seed;
  report.state_hash = simulation.state_hash();
  for (Entity* entity : scene.moving_entities()) {
    report.entities.push_back(report_of(*entity));
    if (const auto* software = control_software::software_report(*entity))
      report.control.push_back({entity->name(), *software});
    for (const sensors::Reading* reading : sensors::readings_of(*entity)) {
      report.sensors.push_back({entity->name(), *reading});
    }
  }
  for (const auto* algorithm : scene.parts().algorithms)
    report.control.push_back({algorithm->name(), algorithm->report()});
  report.algorithms = simulation.statistics();
  report.events = simulation.events();
  report.notes = notes_of(scene);
  report.warnings = warnings_of(scene, lateness);
  return report;
}

std::string events_to_come(const Scene& scene) {
  const scene_file::SceneSpec& spec = scene.spec();
  const Duration now = scene.simulation().now();
  if (now == Duration{}) return {};
  std::vector<std::pair<double, const std::string*>> late;  // [s], and where it is written
  const auto inspect = [&](double time, const std::string& where) {
    if (from_seconds(time) > now - scene.simulation().tick()) late.emplace_back(time, &where);
  };
  for (const scene_file::SceneEvent& event : spec.events) inspect(event.time, event.where);
  for (const scene_file::PushSpec& push : spec.pushes) inspect(push.begin, push.where);
  if (late.empty()) return {};
  // the earliest, which need not be the first in the file
  const auto& [time, where] = *std::ranges::min_element(late, {}, [](const auto& one) { return one.first; });
  return fmt::format("the run ended at {:.3f} s: {} of {} {} did not come, the first at {:.3f} s ({})", seconds(now),
                     late.size(), spec.events.size() + spec.pushes.size(),
                     spec.pushes.empty() ? "events" : "events and pushes", time, *where);
}

}  // namespace murosimf::scene
