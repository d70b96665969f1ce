/// keyframe_player.h - algorithm: plays a key-frame motion once, then holds its last frame.
///
/// Writes `joint_target` of all joints: those that the motion does not name stay at zero (keyframe_pose.h).
#pragma once

#include "murosimf/locomotion/keyframe_pose.h"
#include "murosimf/model/algorithm.h"
#include "murosimf/model/properties.h"
#include "murosimf/model/setup.h"

namespace murosimf::locomotion {

class KeyframePlayer final : public Algorithm {
 public:
  /// Throws SetupError as KeyframePose does.
  KeyframePlayer(Setup& setup, const KeyframeMotion& motion);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 100;

 private:
  KeyframePose pose_;
  double& time_;              // [s] since the start
  std::span<double> target_;  // [rad | m] by object
};

}  // namespace murosimf::locomotion
