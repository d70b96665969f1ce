/// walk_trials.h - walks of many candidates under many circumstances at once, and their costs (walk_tuning.h has the equation).
#pragma once

#include <array>
#include <vector>

#include "murosimf/model/option.h"
#include "murosimf/runtime/pacer.h"
#include "murosimf/studies/tuning_cases.h"
#include "murosimf/studies/walk_watch.h"

namespace murosimf::studies {

struct WalkTask {
  std::array<Vec3d, 4> commands{};  ///< [m/s, m/s, rad/s] of the cases in turn
  double duration = 8;              ///< [s]
  int threads = 1;
  StopRequest stop{};
};

/// By candidate, then by case; empty if it was stopped. `candidates`: options of the controller `walk`. Throws SetupError for a scene that
/// cannot be built.
[[nodiscard]] std::vector<std::vector<WalkOutcome>> walk_trials(const VariedRobot& robot, const WalkTask& task,
                                                                const std::vector<OptionValues>& candidates,
                                                                const std::vector<TuningCase>& cases);

}  // namespace murosimf::studies
