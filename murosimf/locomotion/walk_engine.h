/// walk_engine.h - algorithm: turns a walking velocity into joint targets, for each control cycle.
///
/// Reads `walk_command`; keeps its state in gait_phase, gait_amplitude and gait_velocity, so that it can be watched,
/// saved and restored; writes `joint_target` of all joints (shoulders as arm_swing.h says, others are held at `rest_position`).
#pragma once

#include <vector>

#include "murosimf/locomotion/arm_swing.h"
#include "murosimf/locomotion/gait.h"
#include "murosimf/locomotion/gait_clock.h"
#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::locomotion {

class WalkEngine final : public Algorithm {
 public:
  /// `command` [m/s, m/s, rad/s]: walk_command until another value is set. Parameters are those of the model (gait_seed.h).
  /// Throws SetupError if the model has no two legs as find_legs requires.
  explicit WalkEngine(Setup& setup, const Vec3d& command = {});
  WalkEngine(Setup& setup, const Vec3d& command, const WalkParameters& parameters);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 100;

 private:
  void write_targets(const GaitPose& start) noexcept;

  const std::array<Leg, 2>& legs_;  // the model's
  WalkParameters parameters_;
  GaitClock clock_;
  std::vector<double> rest_;  // [rad | m] by object
  ArmSwing arms_;
  std::span<double> target_;  // [rad] by object
};

}  // namespace murosimf::locomotion
