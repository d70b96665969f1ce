/// trajectory_player.h - algorithm: gives the joints targets from a table of angles over time (trajectory_file.h).
///
/// Writes `joint_target` of all joints: joints outside of the table stay at zero. Its step from t to
/// t + period writes the values of t + period, like a controller that reaches its targets within one cycle (paper 4.3), and as logs
/// record them: the targets of a run, logged at the rate of their controller and played at it, are the same in every step.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "murosimf/control_software/joint_trajectory.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::control_software {

struct TrajectoryOptions {
  std::string file;                       ///< as for find_data_file, kind "motions"
  std::string property = "joint_target";  ///< column of a log to play (LogColumns)
  std::string entity;                     ///< entity whose columns of a log are played; empty: the robot itself
  bool loop = false;                      ///< begins again at its end (loop_period)
  std::optional<double> begin;            ///< [s] in the file; nothing: its first time
  double delay = 0;                       ///< [s] for which it stays at `begin` first
  std::string between = "line";           ///< or "hold"
};

class TrajectoryPlayer final : public Algorithm {
 public:
  /// Throws SetupError if `begin` is not in the file.
  TrajectoryPlayer(Setup& setup, JointTrajectory trajectory, const TrajectoryOptions& options);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

 private:
  void write_targets() noexcept;

  JointTrajectory trajectory_;
  Between between_;
  double begin_, delay_;  // [s]
  double length_;         // [s] played once, from begin_
  double period_;         // [s] of the loop; 0: none
  double& time_;          // [s] since the playing began, negative before
  std::span<double> target_;
};

/// Rate [Hz] at which a table is played: that of its rows if they are equally spaced (whole numbers of Hz where that is
/// within a thousandth), up to that of the usual steps; else 100.
[[nodiscard]] double own_rate(const JointTrajectory& trajectory) noexcept;

}  // namespace murosimf::control_software
