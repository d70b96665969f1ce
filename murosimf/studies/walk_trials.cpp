#include "murosimf/studies/walk_trials.h"

#include <algorithm>
#include <chrono>

#include "murosimf/math/assert.h"
#include "murosimf/scene/scene.h"
#include "murosimf/studies/parallel_runs.h"
#include "murosimf/studies/walk_watch.h"

namespace murosimf::studies {
namespace {

constexpr std::chrono::milliseconds between_walk_looks(50);
/// Of some candidates in one case; empty: stopped.
std::vector<WalkOutcome> walk_in_a_row(const VariedRobot& robot, const WalkTask& task, const Vec3d& command,
                                       std::span<const OptionValues> candidates, const TuningCase& one) {
  MUROSIMF_ASSERT(!candidates.empty());
  scene_file::SceneSpec spec = row_of_robots(robot, one, candidates.size());
  MUROSIMF_ASSERT(spec.robots.size() == candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    spec.robots[i].controller = "walk";
    spec.robots[i].options = candidates[i];
    spec.robots[i].command = command;
  }
  scene::Scene scene(std::move(spec),
                     {.cameras = false, .assets = robot.assets(one.mass, one.gain), .stop = task.stop});
  Simulation& simulation = scene.simulation();
  std::vector<WalkWatch> watches;
  for (const auto& each : scene.spec().robots)
    watches.emplace_back(simulation.world().entity(each.name), command, task.duration);
  // Short runs: a fall is dated by the first look that sees it.
  while (seconds(simulation.now()) < task.duration - 1e-9) {
    simulation.run(between_walk_looks);
    if (simulation.stopped()) return {};
    for (WalkWatch& watch : watches) watch.look(seconds(simulation.now()));
  }
  std::vector<WalkOutcome> outcomes;
  for (const WalkWatch& watch : watches) outcomes.push_back(watch.outcome());
  return outcomes;
}

}  // namespace

std::vector<std::vector<WalkOutcome>> walk_trials(const VariedRobot& robot, const WalkTask& task,
                                                  const std::vector<OptionValues>& candidates,
                                                  const std::vector<TuningCase>& cases) {
  const std::size_t rows = (candidates.size() + robots_in_a_row - 1) / robots_in_a_row;
  std::vector<std::vector<WalkOutcome>> all(candidates.size(), std::vector<WalkOutcome>(cases.size()));
  run_in_parallel(rows * cases.size(), task.threads, task.stop, [&](std::size_t i) {
    const std::size_t which = i / rows, first = i % rows * robots_in_a_row;
    const std::size_t count = std::min(robots_in_a_row, candidates.size() - first);
    MUROSIMF_ASSERT(which < cases.size() && first < candidates.size());
    const auto row = std::span(candidates).subspan(first, count);
    const auto outcomes = walk_in_a_row(robot, task, task.commands[which % task.commands.size()], row, cases[which]);
    MUROSIMF_ASSERT(outcomes.empty() || outcomes.size() == count);
    for (std::size_t k = 0; k < outcomes.size(); ++k) all[first + k][which] = outcomes[k];
  });
  if (task.stop && task.stop()) return {};
  return all;
}

}  // namespace murosimf::studies
