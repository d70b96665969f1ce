/// walk_tuning.h - numbers of a walk for one robot, searched by walking: `murosimf tune walk`.
///
///     const studies::WalkTuning tuned = studies::tune_walk({.model = "robot.urdf"});
///     fmt::print("{}{}", to_text(tuned), to_toml(tuned, "found by tune_walk"));
///
/// First the walk that is computed for the robot (locomotion/gait_seed.h), and 27 combinations of lift, hip_roll and period around it; from the best of
/// them CMA-ES (cost_search.h) over ten numbers of the walk: all but the speeds and how fast they change, which the user chooses. Each candidate
/// walks under eight cases of every level (tuning_cases.h), two for each of four commands: forward, faster, sideways, turning.
///
/// Cost of a walk over the time D:
///     it fell at t:   2 - t/D
///     else            min(1, sqrt(|v - c|^2/s^2 + (w - d)^2/u^2))
/// with the command c, d, the mean velocity v, w in the robot's own frame from 2 s on (D/4, if that is less), s = max(|c|, 0.1 m/s),
/// u = max(|d|, 0.5 rad/s); over cases and levels as mean_and_worst(). The same robot gives the same numbers for any number of threads.
#pragma once

#include <string>
#include <vector>

#include "murosimf/locomotion/gait.h"
#include "murosimf/studies/motion_tuning.h"

namespace murosimf::studies {

struct WalkTuningOptions {
  std::string model;  ///< as in scenes: a file, or the name of one that comes with the program
  std::vector<std::string> levels = usual_tuning_levels();
  double speed =
      0.1;  ///< [m/s] forward; "faster" is the largest of the robot's walk, if that is more, else 1.5 times it
  double duration = 8;  ///< [s] of each walk
  TuningBudget budget;
  scene::SceneOptions common{};  ///< threads, stop, lenient
};

struct WalkTuning {
  OptionValues before, after;  ///< the numbers that are searched (locomotion/walk_options.h)
  CostSearch search;
  std::vector<TuningCheck> checks;  ///< of twenty walks of a level those without a fall; none: it was stopped
};

/// Throws SetupError: a robot that cannot be read or has no legs to walk with, an unknown level, a state of another search.
[[nodiscard]] WalkTuning tune_walk(const WalkTuningOptions& options);

/// Text for users.
[[nodiscard]] std::string to_text(const WalkTuning& tuning);
/// Section [walk] of the TOML file beside the robot, with the best; `how`: lines for its head, like the command.
[[nodiscard]] std::string to_toml(const WalkTuning& tuning, const std::string& how);

}  // namespace murosimf::studies
