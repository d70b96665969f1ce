#include "murosimf/studies/branches.h"

#include <algorithm>
#include <future>
#include <mutex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/studies/chosen_results.h"
#include "murosimf/studies/parallel_runs.h"
#include "murosimf/studies/text_table.h"

namespace murosimf::studies {
namespace {

/// The changes of one branch; empty ones are skipped.
std::vector<std::string> single_changes(const std::string& text) {
  std::vector<std::string> changes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    if (end > begin) changes.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return changes;
}

/// The chosen time, or that of the last whole state.
Duration start_of(const recording::RecordedRun& run, const BranchOptions& options) {
  if (!options.time) {
    const recording::RecordedState* last = run.states().last_until(Duration::max());
    return last ? last->time : run.description().start;
  }
  const bool is_there = *options.time >= run.description().start && *options.time <= run.end();
  if (is_there) return *options.time;
  throw SetupError(fmt::format("{}: it lasts from {} to {} s; there is nothing at {} s", run.file().file().string(),
                               seconds(run.description().start), seconds(run.end()), seconds(*options.time)));
}

Duration end_of(const recording::RecordedRun& run, const BranchOptions& options, const scene::Scene& scene,
                Duration from) {
  if (options.duration) return from + *options.duration;
  return std::max({run.end(), from_seconds(scene.spec().duration), from});
}

/// To the end, with these changes; in a thread of its own.
Branch run_one(const recording::RecordedRun& run, const BranchOptions& options, const std::string& change,
               const std::vector<std::string>& patterns, Branches& all, std::mutex& mutex) {
  recording::RepeatOptions repeat = options.repeat;
  repeat.threads = 1;
  const std::shared_ptr<scene::Scene> scene = run.build(repeat);
  Simulation& simulation = scene->simulation();
  const Duration from = start_of(run, options);
  {
    const std::lock_guard lock(mutex);  // one file, one reader
    run.begin(*scene, from);
  }
  // Between two states the run is repeated up to the moment.
  simulation.run(std::max(Duration{}, from - simulation.now()));
  std::vector<std::future<void>> done;
  for (const std::string& one : single_changes(change)) done.push_back(scene->post(one));
  const Duration begin = simulation.now(), end = end_of(run, options, *scene, begin);
  simulation.run(std::max(Duration{}, end - begin));
  Branch branch{.change = change, .state_hash = simulation.state_hash(), .values = {}};
  if (simulation.stopped()) return branch;
  for (std::future<void>& one : done) {
    if (simulation.now() == begin) throw SetupError("a branch needs some time (--duration)");
    with_context(fmt::format("--set '{}'", change), [&] { one.get(); });
  }
  const std::lock_guard lock(mutex);
  std::vector<std::string> names;
  for (const ChosenResult& result : results_of(*scene, patterns)) {
    names.push_back(result.name);
    branch.values.push_back(result.value);
  }
  // Branches end in any order: the first one names the results, and all others must have the same.
  if (all.results.empty()) all.results = names;
  if (all.results != names) throw SetupError(fmt::format("--set '{}': it has other results than the others", change));
  all.from = begin;
  all.to = simulation.now();
  return branch;
}

std::vector<std::string> head_of(const Branches& branches) {
  std::vector<std::string> head{"branch"};
  head.insert(head.end(), branches.results.begin(), branches.results.end());
  head.emplace_back("state hash");
  return head;
}

std::string name_of(const Branch& branch) { return branch.change.empty() ? "as it was" : branch.change; }

}  // namespace

Branches branch(const recording::RecordedRun& run, const BranchOptions& options) {
  const std::vector<std::string> patterns = options.results.empty() ? usual_results() : options.results;
  Branches all{.file = run.file().file().string(), .from = {}, .to = {}, .results = {}, .branches = {}};
  // The first branch has no change: the others are compared with it.
  all.branches.push_back({});
  for (const std::string& change : options.changes) all.branches.push_back({.change = change, .values = {}});
  MUROSIMF_ASSERT(all.branches.size() == options.changes.size() + 1);
  std::mutex mutex;
  run_in_parallel(all.branches.size(), options.repeat.threads, options.repeat.stop, [&](std::size_t i) {
    all.branches[i] = run_one(run, options, all.branches[i].change, patterns, all, mutex);
  });
  all.stopped = std::ranges::any_of(all.branches, [](const Branch& one) { return one.values.empty(); });
  return all;
}

/// Branches that were stopped have no row.
std::string to_text(const Branches& branches) {
  TextTable table;
  table.add(head_of(branches));
  for (const Branch& one : branches.branches) {
    if (one.values.empty()) continue;
    MUROSIMF_ASSERT(one.values.size() == branches.results.size());
    std::vector<std::string> row{name_of(one)};
    for (const double value : one.values) row.push_back(fmt::format("{:.4g}", value));
    row.push_back(fmt::format("{:016x}", one.state_hash));
    table.add(row);
  }
  return fmt::format("{}: from {:.3f} to {:.3f} s\n", branches.file, seconds(branches.from), seconds(branches.to)) +
         table.text();
}

/// All digits: programs read it.
std::string to_csv(const Branches& branches) {
  std::string text = csv_line(head_of(branches));
  for (const Branch& one : branches.branches) {
    if (one.values.empty()) continue;
    MUROSIMF_ASSERT(one.values.size() == branches.results.size());
    std::vector<std::string> row{name_of(one)};
    for (const double value : one.values) row.push_back(fmt::format("{}", value));
    row.push_back(fmt::format("{:016x}", one.state_hash));
    text += csv_line(row);
  }
  return text;
}

std::string to_json(const Branches& branches) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Branch& one : branches.branches) {
    if (one.values.empty()) continue;
    rows.push_back(
        {{"change", one.change}, {"state_hash", fmt::format("{:016x}", one.state_hash)}, {"results", one.values}});
  }
  return files::json_text({{"schema", files::json_schema("branch")},
                           {"file", branches.file},
                           {"from_s", seconds(branches.from)},
                           {"to_s", seconds(branches.to)},
                           {"results", branches.results},
                           {"branches", rows}});
}

}  // namespace murosimf::studies
