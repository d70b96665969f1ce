#include "murosimf/studies/balance_trials.h"

#include <algorithm>
#include <array>
#include <chrono>

#include <fmt/format.h>

#include "murosimf/locomotion/gait_feedback.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "murosimf/studies/parallel_runs.h"
#include "murosimf/studies/step_learning.h"
#include "murosimf/studies/walk_watch.h"

namespace murosimf::studies {
namespace {

constexpr std::chrono::milliseconds between_balance_looks(50);
constexpr double push_at = 3, push_takes = 0.1;        // [s]
constexpr double weakest = 0.75, strongest = 1.15;     // [1] of the impulse
constexpr double most_falls = 0.25, of_largest = 0.6;  // [1]
constexpr std::array push_ways{Vec3d{1, 0, 0}, Vec3d{-1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, -1, 0}};

/// Pushes act where most of the mass is: lighter bodies would only be shaken.
std::string heaviest_body(const Model& model) {
  std::string heaviest;
  double most = 0;
  for (const int object : model.having(properties::mass)) {
    const double mass = *model.find(properties::mass, object);
    if (mass > most) heaviest = model.objects()[static_cast<std::size_t>(object)].name;
    most = std::max(most, mass);
  }
  return heaviest;
}

/// The first four stand: their commands stay 0.
std::array<Vec3d, robots_of_a_balance> commands_for(const locomotion::WalkParameters& walk, double speed) {
  std::array<Vec3d, robots_of_a_balance> commands{};
  for (std::size_t i = 4; i < 8; ++i) commands[i] = {speed, 0, 0};
  const Vec3d& most = walk.fastest;
  commands[8] = {most.x, 0, 0};
  commands[9] = {-speed, 0, 0};
  commands[10] = {0, of_largest * most.y, 0};
  commands[11] = {0, 0, of_largest * most.z};
  return commands;
}

/// [0, 1] from one of the numbers of the case.
double share_of(const TuningCase& one, std::size_t number) { return 0.5 * (1 + case_number(one, number)); }

class BalanceRun {
 public:
  BalanceRun(const VariedRobot& robot, const BalanceTask& task, const TuningCase& one, const OptionValues& balance,
             const locomotion::StepTablePtr& steps)
      : task_(task), one_(one), kind_(*robot.kind(one.mass, one.gain)) {
    kind_.model = with_balance(*kind_.model, balance, steps);
    walk_ = locomotion::balanced_walk(*kind_.model, {});
    spec_ = row_of_robots(robot, one, robots_of_a_balance);
    MUROSIMF_ASSERT(spec_.robots.size() == robots_of_a_balance);
    commands_ = commands_for(walk_, task.speed);
    for (std::size_t i = 0; i < robots_of_a_balance; ++i) {
      spec_.robots[i].controller = "motions";
      spec_.robots[i].command = commands_[i];
      if (i < 8) add_push(i);
    }
    assets_ = robot.assets_of(kind_);
  }

  /// Costs of the twelve; empty: stopped.
  std::vector<WalkOutcome> run() {
    scene::Scene scene(std::move(spec_), {.cameras = false, .assets = assets_, .stop = task_.stop});
    Simulation& simulation = scene.simulation();
    std::vector<WalkWatch> watches;
    for (std::size_t i = 0; i < robots_of_a_balance; ++i)
      watches.emplace_back(simulation.world().entity(fmt::format("r{}", i)), commands_[i], task_.duration);
    // Short runs: a fall is dated by the first look that sees it.
    while (seconds(simulation.now()) < task_.duration - 1e-9) {
      simulation.run(between_balance_looks);
      if (simulation.stopped()) return {};
      for (WalkWatch& watch : watches) watch.look(seconds(simulation.now()));
    }
    std::vector<WalkOutcome> outcomes;
    for (const WalkWatch& watch : watches) outcomes.push_back(watch.outcome());
    MUROSIMF_ASSERT(outcomes.size() == robots_of_a_balance);
    return outcomes;
  }

  /// Strength and instant come from the case: two numbers for each push.
 private:
  void add_push(std::size_t i) {
    MUROSIMF_ASSERT(i < spec_.robots.size());
    const double impulse = task_.impulse * (weakest + (strongest - weakest) * share_of(one_, 2 * i));
    const double begin = push_at + walk_.period * share_of(one_, 2 * i + 1);
    spec_.pushes.push_back(
        {.where = "",
         .entities = {spec_.robots[i].name},
         .object = heaviest_body(*kind_.model),
         .force = impulse / push_takes * (rotation_z(one_.heading) * push_ways[i % push_ways.size()]),
         .begin = begin,
         .end = begin + push_takes});
  }

  const BalanceTask& task_;
  const TuningCase& one_;
  scene::RobotKind kind_;
  locomotion::WalkParameters walk_;
  scene_file::SceneSpec spec_;
  std::array<Vec3d, robots_of_a_balance> commands_{};
  std::shared_ptr<scene::Assets> assets_;
};

}  // namespace

LearnedSteps steps_for(const VariedRobot& robot, const OptionValues& balance, const LearningEffort& effort, int threads,
                       const StopRequest& stop) {
  StepLearningOptions options{.model = robot.file().string(),
                              .rigid = {"full_dynamics"},
                              .duration = effort.duration,
                              .rounds = effort.rounds};
  options.robot = robot.kind(1, 1);
  options.balance = balance;
  options.common.threads = threads;
  options.common.stop = stop;
  const StepLearning learning = learn_steps(options);
  if (learning.stopped || learning.rounds.empty()) return {};
  const StepLearning::Round& last = learning.rounds.back();
  MUROSIMF_ASSERT(last.walks > 0 && last.fell <= last.walks);
  return {.table = std::make_shared<const locomotion::StepTable>(learning.table),
          .fell = static_cast<double>(last.fell) / static_cast<double>(last.walks)};
}

std::vector<BalanceOutcome> balance_trials(const VariedRobot& robot, const BalanceTask& task,
                                           const std::vector<OptionValues>& candidates,
                                           const std::vector<TuningCase>& cases) {
  std::vector<LearnedSteps> steps(candidates.size());
  run_in_parallel(candidates.size(), task.threads, task.stop,
                  [&](std::size_t i) { steps[i] = steps_for(robot, candidates[i], task.learning, 1, task.stop); });
  if (task.stop && task.stop()) return {};
  std::vector<BalanceOutcome> all(candidates.size());
  // What a candidate costs that falls too often while it learns; the runs below replace it for the others.
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    all[i].costs.assign(cases.size(), 2 + steps[i].fell);
    all[i].stood.assign(cases.size(), 0);
  }
  run_in_parallel(candidates.size() * cases.size(), task.threads, task.stop, [&](std::size_t k) {
    const std::size_t i = k / cases.size(), which = k % cases.size();
    MUROSIMF_ASSERT(i < candidates.size());
    if (steps[i].fell > most_falls) return;
    const std::vector<WalkOutcome> outcomes =
        BalanceRun(robot, task, cases[which], candidates[i], steps[i].table).run();
    if (outcomes.empty()) return;  // stopped
    double sum = 0;
    for (const WalkOutcome& one : outcomes) {
      sum += one.cost;
      all[i].stood[which] += one.fell ? 0 : 1;
    }
    all[i].costs[which] = sum / static_cast<double>(outcomes.size());
  });
  if (task.stop && task.stop()) return {};
  return all;
}

}  // namespace murosimf::studies
