/// bench_logs.h - simulates logs of servos on a bench: eight of them step through one kernel.
///
/// Every log, or piece of one, is run open loop: it starts at the measured state, then only goal, voltage and torque
/// switch of the log go in, sampled on the grid of the simulation's steps: goal and switch as of the last entry, since a servo
/// holds what its driver sent last; the voltage, which was measured, linear in between.
#pragma once

#include <span>
#include <vector>

#include "murosimf/identification/servo_log.h"
#include "murosimf/math/pack.h"
#include "murosimf/multibody/servo/servo_pendulum.h"

namespace murosimf::identification {

/// Entries of a log to simulate: first to last.
struct Piece {
  const ServoLog* log = nullptr;
  std::size_t first = 0, last = 0;
  double rate = 0;  ///< [rad/s] at the first
};

/// All entries of a log.
[[nodiscard]] Piece whole(const ServoLog& log);

class BenchLogs {
 public:
  /// `duty_per_gain` [1/rad]: duty cycle per firmware gain and angle of error. `step` [s].
  BenchLogs(std::vector<Piece> pieces, double duty_per_gain, double step);

  /// Simulates all pieces, and writes the mean of |q_sim - q| [rad] of each to `errors` (as many as there are pieces).
  void errors(const multibody::BenchServo& servo, std::span<double> errors);

  /// The simulated position [rad] at every entry of piece `i`, as of the last errors().
  [[nodiscard]] std::vector<double> positions(std::size_t i) const;

  [[nodiscard]] std::size_t size() const { return pieces_.size(); }

 private:
  struct Lanes {
    multibody::Bench<Pack8> bench;
    multibody::BenchState<Pack8> start;
    std::vector<multibody::BenchInput<Pack8>> inputs;  ///< of each step
    std::vector<Pack8> positions;                      ///< [rad] before the first step, and after each
  };

  void fill_lane(Lanes& lanes, int lane, const Piece& piece, double duty_per_gain) const;
  void simulate(const multibody::BenchServo& servo, Lanes& lanes) const;
  [[nodiscard]] double position_at(std::size_t piece, double time) const;

  std::vector<Piece> pieces_;
  double step_;
  std::vector<Lanes> packs_;
};

}  // namespace murosimf::identification
