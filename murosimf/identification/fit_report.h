/// fit_report.h - reports of a fit or a replay of servo logs: as a table, and as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/identification/fitted_servo.h"

namespace murosimf::identification {

/// Errors of logs that a fit has not seen.
struct UnseenGroup {
  std::string name;  ///< what was left out: a trajectory, a gain
  std::vector<LogError> logs;
};

/// A share of windows that was tried, and the error of its predictions.
struct TriedWindows {
  double share = 0;
  double error = 0;  ///< [rad] mean of all logs, each by the fit that has not seen its trajectory
};

struct FitReport {
  FittedServo servo;
  double window_share = 0;                  ///< of the fit
  std::vector<TriedWindows> tried_windows;  ///< empty: the share was given, or nothing could be tried
  std::uint64_t seed = 0;
  std::vector<double> costs;                 ///< [rad] that the starts of the search reached
  std::vector<LogError> validated;           ///< logs that were not fitted
  std::vector<UnseenGroup> cross_validated;  ///< each by a fit of its own to the other logs
  bool stopped = false;                      ///< before the search ended: the servo is the best so far
};

struct ReplayReport {
  std::string servo;
  std::vector<LogError> logs;
};

/// [rad] mean of the logs' errors, 0 if there are none.
[[nodiscard]] double mean_error(const std::vector<LogError>& logs);

[[nodiscard]] std::string to_text(const FitReport& report);
[[nodiscard]] std::string to_text(const ReplayReport& report);

/// One JSON object: model, base, prior, seed, stopped, costs_rad [], window_share, tried_windows [{share, error_rad}] (if any),
/// parameters {name: value}, mean_error_rad,
/// logs [{name, trajectory, firmware_gain, error_rad}], validated [the same], mean_validated_error_rad (if any),
/// cross_validated [{unseen, error_rad, logs}], mean_cross_validated_error_rad (if any).
[[nodiscard]] std::string to_json(const FitReport& report);
/// One JSON object: servo, mean_error_rad, logs [as above].
[[nodiscard]] std::string to_json(const ReplayReport& report);

}  // namespace murosimf::identification
