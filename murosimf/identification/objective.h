/// objective.h - the cost of a servo's numbers: how badly they explain logs.
///
///     (1 - s) mean error of whole logs + 4 s mean error of windows + cost of the prior        [rad]
///
/// Whole logs are what counts, but where an arm sticks is a matter of chance, and one wrong stop hides everything that
/// comes after it. Windows of 0.6 s, each started at the measured state, see every part of a log; their errors are about
/// four times smaller. Both are open loop: mean of |q_sim - q| over all entries.
#pragma once

#include <span>
#include <vector>

#include "murosimf/identification/bench_logs.h"
#include "murosimf/identification/parameter.h"
#include "murosimf/identification/prior.h"

namespace murosimf::identification {

/// Data of the servo's firmware, and the weights of errors.
struct ObjectiveOptions {
  double duty_per_gain = 0;  ///< [1/rad] duty cycle per firmware gain and angle of error
  double duty_limit = 1;     ///< [1]
  double current_limit = 0;  ///< [A]; 0: none
  double window_share = 0;   ///< s, 0 to 1; chosen by window_choice.h
  double step = 2.5e-3;      ///< [s] of the simulation
};

class Objective {
 public:
  /// Keeps references to model, prior and logs.
  Objective(const FrictionModel& model, const Prior& prior, std::span<const ServoLog> logs,
            const ObjectiveOptions& options);

  /// The cost for places of the parameters between their bounds, each 0 to 1.
  double operator()(std::span<const double> places);

  [[nodiscard]] multibody::BenchServo servo_at(std::span<const double> places) const;
  /// Parameters of the model, with bounds that the prior narrows.
  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  [[nodiscard]] const Prior& prior() const { return prior_; }

 private:
  const Prior& prior_;
  std::vector<Parameter> parameters_;
  ObjectiveOptions options_;
  BenchLogs logs_, windows_;
  std::vector<double> errors_, window_errors_;
};

}  // namespace murosimf::identification
