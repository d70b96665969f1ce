/// balance_trials.h - walks with feedback of many candidates, undisturbed and pushed, and their costs.
///
/// Every candidate first learns how its own steady walk looks (step_learning.h, by walks at `full_dynamics` and
/// `articulated_dynamics`): if it falls in more than a quarter of these, it costs 2 and the share of falls, and is not tried further.
/// Else twelve of it are in every case at once:
///
///     0 to 3    stand, and are pushed forward, backward, to the left, to the right, for 0.1 s
///     4 to 7    walk with the wanted speed, and are pushed likewise
///     8 to 11   walk undisturbed: as fast as it walks, backward with the wanted speed, sideways and turning with 0.6 of the largest
/// The impulse is 0.75 to 1.15 of the wanted one, and begins at any instant of a step, each as the seed of the case says. A run costs
/// what a walk costs (walk_tuning.h), a case the mean over its twelve.
#pragma once

#include <vector>

#include "murosimf/locomotion/step_table.h"
#include "murosimf/model/option.h"
#include "murosimf/runtime/pacer.h"
#include "murosimf/studies/tuning_cases.h"

namespace murosimf::studies {

inline constexpr std::size_t robots_of_a_balance = 12;

/// What a candidate learns its steady walk from. Of two rounds the first walks without feedback, the second with what was learned.
struct LearningEffort {
  double duration = 4;  ///< [s] of each walk
  int rounds = 2;
};

struct BalanceTask {
  double speed = 0.15;  ///< [m/s]
  double impulse = 3;   ///< [N s]
  double duration = 7;  ///< [s] of each run; the push begins at 3 s or within a step after that
  LearningEffort learning{};
  int threads = 1;
  StopRequest stop{};
};

struct BalanceOutcome {
  std::vector<double> costs;       ///< by case
  std::vector<std::size_t> stood;  ///< by case: of the twelve those that did not fall
};

/// By candidate, each values of options of [balance] (locomotion/gait_feedback.h); empty if it was stopped. Throws SetupError for a scene
/// that cannot be built.
[[nodiscard]] std::vector<BalanceOutcome> balance_trials(const VariedRobot& robot, const BalanceTask& task,
                                                         const std::vector<OptionValues>& candidates,
                                                         const std::vector<TuningCase>& cases);

struct LearnedSteps {
  locomotion::StepTablePtr table;  ///< null: it was stopped
  double fell = 0;                 ///< [1] of the walks
};
/// As the trials learn them.
[[nodiscard]] LearnedSteps steps_for(const VariedRobot& robot, const OptionValues& balance,
                                     const LearningEffort& effort, int threads, const StopRequest& stop);

}  // namespace murosimf::studies
