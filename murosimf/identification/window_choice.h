/// window_choice.h - decides whether a fit uses windows of the logs, by its predictions.
///
/// Fits with each share of windows (objective.h) are made to the logs of all trajectories but one, and predict those that
/// were left out. A model has a usual share, and other shares have to be clearly better: of those with errors on the same
/// logs are lower by more than two standard errors of the mean difference, the one with the lowest mean error is taken.
/// Source of the rule: the paired t-test, and the habit of not leaving what cannot be told apart (Breiman et al.,
/// "Classification and Regression Trees", 1984, 3.4.3).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "murosimf/identification/parameter.h"

namespace murosimf::identification {

inline constexpr std::array window_shares{0.0, 0.5, 0.8};  ///< that are tried

/// Errors of the predictions with one share of windows.
struct WindowTrial {
  double share = 0;            ///< 0 to 1
  std::vector<double> errors;  ///< [rad] of each log, by the fit that has not seen its trajectory
};

/// [rad]
[[nodiscard]] double mean_error(const WindowTrial& trial);

/// Index of the best trial; `usual` is that of the usual share. All have the errors of the same logs, in the same order.
[[nodiscard]] std::size_t best_trial(std::span<const WindowTrial> trials, std::size_t usual);

/// One of window_shares: 0.8 for models in which friction follows the load, otherwise 0. Such friction shows in every part of
/// a log, where an arm stops is a matter of chance; without it only whole logs keep friction from hiding in the motor
/// (docs/servos.md has the measurement).
[[nodiscard]] double usual_window_share(const FrictionModel& model);

}  // namespace murosimf::identification
