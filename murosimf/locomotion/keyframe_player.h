/// keyframe_player.h - algorithm: plays a key-frame motion once, then holds its last frame.
///
/// Writes `joint_target` of all joints, as described in keyframe_targets.h.
#pragma once

#include <span>
#include <vector>

#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/locomotion/keyframe_targets.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::locomotion {

class KeyframePlayer final : public Algorithm {
 public:
  /// Throws SetupError as KeyframeTargets.
  KeyframePlayer(Setup& setup, const KeyframeMotion& motion);

  /// Replaces the motion from the next initialize() on: one with the same columns and other values, durations or number of frames.
  void play(const KeyframeMotion& motion);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 100;

 private:
  void write_targets() noexcept;

  KeyframeMotion motion_;
  double duration_;  // [s]
  KeyframeTargets targets_;
  std::vector<double> values_;  // by column
  double& time_;                // [s] since the start
  std::span<double> target_;    // [rad | m] by object
};

}  // namespace murosimf::locomotion
