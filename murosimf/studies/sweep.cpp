#include "murosimf/studies/sweep.h"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/model/error.h"
#include "murosimf/scene/assets.h"
#include "murosimf/studies/chosen_results.h"
#include "murosimf/studies/parallel_runs.h"
#include "murosimf/studies/sweep_file.h"
#include "murosimf/studies/sweep_plan.h"

namespace murosimf::studies {
namespace {

std::vector<double> run_one(const SweepOptions& options, const SweepPlan& plan, const GridPoint& point) {
  scene::Scene scene(options.scene, scene_options(options, point));
  scene.simulation().run(plan.duration);
  if (scene.simulation().stopped()) return {};
  std::vector<double> values;
  std::vector<std::string> names;
  for (const ChosenResult& result : results_of(scene, plan.patterns)) {
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

/// Runs that are done already, here or by others.
void take_over(Sweep& result, const SweepOptions& options, const SweepPlan& plan,
               const std::optional<SweepFile>& file) {
  FinishedRuns finished;
  if (!options.others.empty()) finished = finished_runs(options.others, plan.description, plan.results.size());
  if (file) finished.insert(file->known().begin(), file->known().end());
  for (const auto& [run, values] : finished) {
    if (run >= result.runs.size()) continue;
    result.runs[run].values = values;
    if (options.shard.has(run)) ++result.taken_over;
  }
}

}  // namespace

Sweep empty_sweep(const SweepOptions& options, const SweepPlan& plan) {
  Sweep result{.scene = options.scene_name.empty() ? options.scene : options.scene_name,
               .axes = {},
               .results = plan.results,
               .runs = {}};
  for (const GridAxis& axis : options.axes) result.axes.push_back(axis.path);
  for (const GridPoint& point : plan.points) result.runs.push_back({.point = point, .values = {}});
  return result;
}

Sweep sweep(const SweepOptions& given) {
  SweepOptions options = given;
  const SweepPlan plan = plan_of(options);
  if (!options.common.assets) options.common.assets = plan.assets;
  if (options.check) options.check(plan);
  Sweep result = empty_sweep(options, plan);

  std::optional<SweepFile> file;
  if (!options.file.empty()) file.emplace(options.file, plan.description, plan.results.size());
  take_over(result, options, plan, file);
  std::vector<std::size_t> to_do;
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    if (options.shard.has(i) && result.runs[i].values.empty()) to_do.push_back(i);
  }

  std::mutex mutex;
  std::size_t done = 0;
  run_in_parallel(to_do.size(), options.common.threads, options.common.stop, [&](std::size_t i) {
    SweepRun& run = result.runs[to_do[i]];
    std::vector<double> values = run_one(options, plan, run.point);
    const std::lock_guard lock(mutex);
    if (values.empty()) return;  // stopped
    if (file && result.not_noted.empty()) note(*file, to_do[i], values, result.not_noted);
    run.values = std::move(values);
    ++done;
    if (options.progress) options.progress(result.taken_over + done, result.taken_over + to_do.size());
  });
  result.stopped = done < to_do.size();
  return result;
}

std::size_t missing_runs(const Sweep& sweep) {
  return static_cast<std::size_t>(
      std::ranges::count_if(sweep.runs, [](const SweepRun& run) { return run.values.empty(); }));
}

}  // namespace murosimf::studies
