#include "murosimf/studies/sweep.h"

#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/file_access.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/scene/assets.h"
#include "murosimf/studies/chosen_results.h"
#include "murosimf/studies/parallel_runs.h"
#include "murosimf/studies/sweep_file.h"

namespace murosimf::studies {
namespace {

/// How the scene of a run is built.
scene::SceneOptions options_of(const SweepOptions& sweep, const GridPoint& point) {
  MUROSIMF_ASSERT(point.values.size() == sweep.axes.size());
  scene::SceneOptions options = sweep.common;
  options.threads = 1;
  options.seed = point.seed;
  for (std::size_t i = 0; i < point.values.size(); ++i) {
    options.overrides.push_back(sweep.axes[i].path + "=" + point.values[i]);
  }
  return options;
}

/// What is the same for all runs, found out with the first one, which is not stepped.
struct Plan {
  std::vector<GridPoint> points;
  std::vector<std::string> results;  // names
  Duration duration{};
  std::string what;  // of the file
};

std::string describe(const SweepOptions& options, const Plan& plan, const files::FilesRead& read) {
  nlohmann::json axes = nlohmann::json::array();
  for (const GridAxis& axis : options.axes) axes.push_back({{"path", axis.path}, {"values", axis.values}});
  const nlohmann::json what{{"program", options.program},
                            {"scene", options.scene},
                            {"axes", axes},
                            {"seeds", options.seeds},
                            {"duration_ns", plan.duration.count()},
                            {"results", plan.results},
                            {"set", options.common.overrides},
                            {"at", options.common.events},
                            {"push", options.common.pushes},
                            {"lenient", options.common.lenient},
                            {"cameras", options.common.cameras},
                            {"files", recording::files_now(read.list(), {read.list(), {}}).list.values}};
  return what.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Plan plan_of(const SweepOptions& options, const std::vector<std::string>& patterns) {
  Plan plan;
  const auto read = std::make_shared<files::FilesRead>();
  const files::FileScope noting({.noted = read});
  scene::SceneOptions as_it_is = options.common;
  as_it_is.threads = 1;
  std::vector<std::uint64_t> seeds = options.seeds;
  if (seeds.empty()) seeds.push_back(scene::Scene(options.scene, as_it_is).spec().seed);
  plan.points = points_of(options.axes, seeds);
  scene::Scene first(options.scene, options_of(options, plan.points.front()));
  first.simulation().initialize();
  for (const ChosenResult& result : results_of(first, patterns)) plan.results.push_back(result.name);
  plan.duration = from_seconds(options.duration.value_or(first.spec().duration));
  plan.what = describe(options, plan, *read);
  return plan;
}

std::vector<double> run_one(const SweepOptions& options, const Plan& plan, const GridPoint& point,
                            const std::vector<std::string>& patterns) {
  scene::Scene scene(options.scene, options_of(options, point));
  scene.simulation().run(plan.duration);
  if (scene.simulation().stopped()) return {};
  std::vector<double> values;
  std::vector<std::string> names;
  for (const ChosenResult& result : results_of(scene, patterns)) {
    values.push_back(result.value);
    names.push_back(result.name);
  }
  if (names != plan.results) {
    throw SetupError(fmt::format("seed {}, {}: it has other results than the first run: {}", point.seed,
                                 fmt::join(point.values, ", "), fmt::join(names, ", ")));
  }
  MUROSIMF_ASSERT(values.size() == plan.results.size());
  return values;
}

/// A sweep continues without its file where the disk is full; `trouble` has the reason.
void note(SweepFile& file, std::size_t run, const std::vector<double>& values, std::string& trouble) {
  try {
    file.add(run, values);
  } catch (const SetupError& error) {
    trouble = error.what();
  }
}

}  // namespace

Sweep sweep(const SweepOptions& given) {
  SweepOptions options = given;
  if (!options.common.assets) options.common.assets = std::make_shared<scene::Assets>();
  const std::vector<std::string> patterns = options.results.empty() ? usual_results() : options.results;
  const Plan plan = plan_of(options, patterns);
  Sweep result{.scene = options.scene, .axes = {}, .results = plan.results, .runs = {}};
  for (const GridAxis& axis : options.axes) result.axes.push_back(axis.path);
  for (const GridPoint& point : plan.points) result.runs.push_back({.point = point, .values = {}});

  std::optional<SweepFile> file;
  std::vector<std::size_t> to_do;
  if (!options.file.empty()) file.emplace(options.file, plan.what, plan.results.size());
  if (file) {
    for (const auto& [run, values] : file->known()) {
      if (run < result.runs.size()) result.runs[run].values = values;
    }
  }
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    if (result.runs[i].values.empty()) to_do.push_back(i);
  }
  result.taken_over = result.runs.size() - to_do.size();

  std::mutex mutex;
  std::size_t done = result.taken_over;
  run_in_parallel(to_do.size(), options.common.threads, options.common.stop, [&](std::size_t i) {
    SweepRun& run = result.runs[to_do[i]];
    std::vector<double> values = run_one(options, plan, run.point, patterns);
    const std::lock_guard lock(mutex);
    if (values.empty()) return;  // stopped
    if (file && result.not_noted.empty()) note(*file, to_do[i], values, result.not_noted);
    run.values = std::move(values);
    ++done;
    if (options.progress) options.progress(done, result.runs.size());
  });
  result.stopped = done < result.runs.size();
  return result;
}

}  // namespace murosimf::studies
