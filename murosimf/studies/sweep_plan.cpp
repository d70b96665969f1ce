#include "murosimf/studies/sweep_plan.h"

#include <nlohmann/json.hpp>

#include "murosimf/files/file_access.h"
#include "murosimf/math/assert.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/scene/assets.h"
#include "murosimf/studies/chosen_results.h"

namespace murosimf::studies {
namespace {

std::string describe(const SweepOptions& options, const SweepPlan& plan, const files::FilesRead& read) {
  nlohmann::json axes = nlohmann::json::array();
  for (const GridAxis& axis : options.axes) axes.push_back({{"path", axis.path}, {"values", axis.values}});
  const nlohmann::json what{{"program", options.program},
                            {"scene", options.scene_name.empty() ? options.scene : options.scene_name},
                            {"axes", axes},
                            {"seeds", plan.seeds},
                            {"duration_ns", plan.duration.count()},
                            {"patterns", plan.patterns},
                            {"results", plan.results},
                            {"set", options.common.overrides},
                            {"at", options.common.events},
                            {"push", options.common.pushes},
                            {"lenient", options.common.lenient},
                            {"cameras", options.common.cameras},
                            {"files", recording::files_now(read.list(), {read.list(), {}}).list.values}};
  return what.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Numbers and lists of them name no file.
bool may_name_a_file(const std::string& value) {
  return value.find_first_not_of("0123456789.,+-eE[] ") != std::string::npos;
}

/// Reads what other runs than the first read: each value of each axis in turn, with the first ones of the others.
void read_other_files(const SweepOptions& options, const GridPoint& first) {
  for (std::size_t axis = 0; axis < options.axes.size(); ++axis) {
    const std::vector<std::string>& values = options.axes[axis].values;
    for (std::size_t i = 1; i < values.size(); ++i) {
      if (!may_name_a_file(values[i])) continue;
      GridPoint point = first;
      point.values[axis] = values[i];
      const scene::Scene read(options.scene, scene_options(options, point));
    }
  }
}

}  // namespace

scene::SceneOptions scene_options(const SweepOptions& sweep, const GridPoint& point) {
  MUROSIMF_ASSERT(point.values.size() == sweep.axes.size());
  scene::SceneOptions options = sweep.common;
  options.threads = 1;
  options.seed = point.seed;
  for (std::size_t i = 0; i < point.values.size(); ++i) {
    options.overrides.push_back(sweep.axes[i].path + "=" + point.values[i]);
  }
  return options;
}

SweepPlan plan_of(const SweepOptions& given) {
  SweepPlan plan{.patterns = given.results.empty() ? usual_results() : given.results,
                 .seeds = given.seeds,
                 .points = {},
                 .results = {},
                 .assets = std::make_shared<scene::Assets>(),
                 .description = {}};
  SweepOptions options = given;
  options.common.assets = plan.assets;  // what older ones have loaded would not be read, and so not be described
  const auto read = std::make_shared<files::FilesRead>();
  const files::FileScope noting({.noted = read});
  scene::SceneOptions as_it_is = options.common;
  as_it_is.threads = 1;
  if (plan.seeds.empty()) plan.seeds.push_back(scene::Scene(options.scene, as_it_is).spec().seed);
  plan.points = points_of(options.axes, plan.seeds);
  scene::Scene first(options.scene, scene_options(options, plan.points.front()));
  first.simulation().initialize();
  for (const ChosenResult& result : results_of(first, plan.patterns)) plan.results.push_back(result.name);
  plan.duration = from_seconds(options.duration.value_or(first.spec().duration));
  read_other_files(options, plan.points.front());
  plan.description = describe(options, plan, *read);
  return plan;
}

}  // namespace murosimf::studies
