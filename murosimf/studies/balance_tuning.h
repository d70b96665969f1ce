/// balance_tuning.h - a walk with feedback for one robot, gait and feedback at once, searched by walking and being pushed: `murosimf tune balance`.
///
///     const studies::BalanceTuning tuned = studies::tune_balance({.model = "robot.urdf"});
///     fmt::print("{}{}", to_text(tuned), to_toml(tuned, "found by tune_balance", "robot_steps.csv"));
///
/// CMA-ES (cost_search.h) over ten numbers of the gait and all of the feedback (tuned_numbers.h), from those that the robot has. The costs are those of
/// balance_trials.h, under some cases of every level (tuning_cases.h), mean and worst level together. The same options give the same
/// numbers for any number of threads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/locomotion/step_table.h"
#include "murosimf/studies/balance_trials.h"
#include "murosimf/studies/motion_tuning.h"

namespace murosimf::studies {

struct BalanceTuningOptions {
  std::string model;  ///< as in scenes: a file, or the name of one that comes with the program
  std::vector<std::string> levels = usual_tuning_levels();
  double speed = 0.15;              ///< [m/s] at which it is pushed while it walks
  std::optional<double> impulse{};  ///< [N s]; nothing: 0.45 m sqrt(g l), mass m, thigh and shin l
  double duration = 7;              ///< [s] of each run
  LearningEffort learning{};
  std::size_t cases = 2, checks = 6;  ///< of every level: of the search, and afterwards
  TuningBudget budget;
  scene::SceneOptions common{};  ///< threads, stop, lenient
};

struct BalanceTuning {
  OptionValues before, after;      ///< the numbers that are searched
  OptionValues kept;               ///< what [balance] of the robot has besides
  double impulse = 0;              ///< [N s]
  locomotion::StepTablePtr steps;  ///< how the walk with the best looks; null: it was stopped
  CostSearch search;
  std::vector<TuningCheck> checks;  ///< of twelve runs of each case those without a fall; none: it was stopped
};

/// Throws SetupError: a robot that cannot be read or has no legs to walk with, an unknown level or one that ignores pushes, a state of
/// another search.
[[nodiscard]] BalanceTuning tune_balance(const BalanceTuningOptions& options);

/// Text for users.
[[nodiscard]] std::string to_text(const BalanceTuning& tuning);
/// Section [balance] of the TOML file beside the robot, with the best and the table of steps in the file `steps`; `how`: lines for its head.
[[nodiscard]] std::string to_toml(const BalanceTuning& tuning, const std::string& how, const std::string& steps);

}  // namespace murosimf::studies
