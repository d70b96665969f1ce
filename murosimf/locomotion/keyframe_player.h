/// keyframe_player.h - algorithm: plays a key-frame motion once, then holds its last frame.
///
/// Writes `joint_target` of all joints: those that the motion does not name stay at zero. If the motion moves feet, both
/// legs follow by inverse kinematics (leg.h) from the stance in which the walk engine stands (gait.h): x forward, y to the left, z up,
/// each in the level frame of the pelvis; angles that the motion gives to leg joints come on top.
#pragma once

#include <array>
#include <vector>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/model/algorithm.h"
#include "murosimf/model/properties.h"
#include "murosimf/model/setup.h"

namespace murosimf::locomotion {

class KeyframePlayer final : public Algorithm {
 public:
  /// Throws SetupError if the motion names a channel that the model does not have, or moves feet of a model without legs
  /// as leg.h describes them, or cannot be mirrored where it is for the other side.
  KeyframePlayer(Setup& setup, const KeyframeMotion& motion);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 100;

 private:
  /// One value of the motion and where it goes: an object, or an axis of a foot.
  struct JointSink {
    std::size_t column = 0;
    double sign = 1;
    int object = 0;
  };
  struct FootSink {
    std::size_t column = 0;
    double sign = 1;
    std::size_t side = 0;  // 0: left
    std::size_t axis = 0;  // of foot_axes
  };
  using FootPlace = std::array<double, 4>;  // [m, m, m, rad] x, y, z, pitch from the stance

  void connect(const Model& model, const Channel& channel, std::size_t column);
  void write_targets() noexcept;
  void place_feet() noexcept;

  KeyframeMotion motion_;
  const double duration_;  // [s]
  std::vector<JointSink> joint_sinks_;
  std::vector<FootSink> foot_sinks_;
  std::array<Leg, 2> legs_;     // if feet are moved
  WalkParameters stance_;       // likewise
  std::vector<double> values_;  // by column
  double& time_;                // [s] since the start
  std::span<double> target_;    // [rad | m] by object
};

}  // namespace murosimf::locomotion
