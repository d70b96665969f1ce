/// servo_logs.h - what fit-servo and replay-servo share: a servo's errors over logs.
#pragma once

#include <span>
#include <vector>

#include "murosimf/identification/bench_logs.h"
#include "murosimf/identification/fitted_servo.h"

namespace murosimf::app {

inline constexpr double replay_step = 1e-3;  ///< [s]

/// A servo, and the simulation of logs on its bench.
class ServoReplay {
 public:
  /// Throws SetupError if the servo cannot be put on the bench.
  ServoReplay(const identification::FittedServo& fitted, std::span<const identification::ServoLog> logs);

  [[nodiscard]] const std::vector<identification::LogError>& errors() const { return errors_; }
  /// [rad] at every entry of log `i`.
  [[nodiscard]] std::vector<double> positions(std::size_t i) const { return bench_.positions(i); }

 private:
  identification::BenchLogs bench_;
  std::vector<identification::LogError> errors_;
};

}  // namespace murosimf::app
