#include "murosimf/studies/chosen_results.h"

#include <limits>

#include "murosimf/logging/log_paths.h"
#include "murosimf/logging/log_plot.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::studies {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// All numbers of the report, entity by entity.
std::vector<ChosenResult> reported(const scene::Scene& scene) {
  std::vector<ChosenResult> all;
  for (const scene::EntityReport& one : make_report(scene).entities) {
    all.push_back({one.name + ".distance [m]", one.distance});
    all.push_back({one.name + ".falls", static_cast<double>(one.falls)});
    all.push_back({one.name + ".frozen", one.frozen ? 1.0 : 0.0});
    all.push_back({one.name + ".present", one.present ? 1.0 : 0.0});
    all.push_back({one.name + ".x [m]", one.position.x});
    all.push_back({one.name + ".y [m]", one.position.y});
    all.push_back({one.name + ".z [m]", one.position.z});
  }
  return all;
}

/// The numbers that the same pattern means for --log; errors name this option instead.
std::vector<logging::LoggedNumber> logged(const World& world, const std::string& pattern) {
  try {
    return logging::find_logged(world, {pattern});
  } catch (const SetupError& error) {
    const std::string text = error.what(), option = "--log ";
    throw SetupError(text.starts_with(option) ? "--result " + text.substr(option.size()) : text);
  }
}

double value_of(const logging::LoggedNumber& number) {
  if (!number.entity->present()) return nothing;
  if (number.sensor.empty()) {
    if (!number.entity->find(number.property)) return nothing;
    return ObjectAccess(*number.entity, number.object).get(number.property).numbers[number.index];
  }
  for (const sensors::Reading* reading : sensors::readings_of(*number.entity)) {
    if (reading->info->name != number.sensor) continue;
    return number.index < reading->values.size() ? reading->values[number.index] : nothing;
  }
  return nothing;
}

}  // namespace

const std::vector<std::string>& usual_results() {
  static const std::vector<std::string> names = {"*.distance", "*.falls"};
  return names;
}

std::vector<ChosenResult> results_of(scene::Scene& scene, const std::vector<std::string>& patterns) {
  const std::vector<ChosenResult> report = reported(scene);
  std::vector<ChosenResult> results;
  for (const std::string& pattern : patterns) {
    const std::size_t before = results.size();
    for (const ChosenResult& one : report) {
      if (logging::matches_name(pattern, one.name.substr(0, one.name.find(" [")))) results.push_back(one);
    }
    // A pattern that matches nothing in the report may name a logged number.
    if (results.size() > before) continue;
    for (const logging::LoggedNumber& number : logged(scene.simulation().world(), pattern)) {
      results.push_back({number.name(), value_of(number)});
    }
  }
  return results;
}

}  // namespace murosimf::studies
