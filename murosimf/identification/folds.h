/// folds.h - logs that are left out of a fit, to measure its predictions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/identification/servo_log.h"

namespace murosimf::identification {

struct Fold {
  std::string unseen;  ///< trajectory or gain of the logs that are left out
  std::vector<ServoLog> fitted, left_out;
};

/// Whether there is more than one trajectory, so that one can be left out.
[[nodiscard]] bool has_other_trajectories(std::span<const ServoLog> logs);

/// One fold per trajectory or gain ("trajectory", "gain") of the logs. Throws SetupError if all logs have the same, or
/// the name is another.
[[nodiscard]] std::vector<Fold> folds(std::span<const ServoLog> logs, std::string_view by);

}  // namespace murosimf::identification
