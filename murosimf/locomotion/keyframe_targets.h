/// keyframe_targets.h - joint targets of the values of a key-frame motion for one model.
///
/// Joints that the motion does not name are held at `rest_position`. If it moves feet, both legs follow by inverse kinematics (leg.h) from the stance
/// in which the walk engine stands (gait.h): x forward, y to the left, z up, each in the level frame of the pelvis; angles that the motion
/// gives to leg joints come on top.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "murosimf/locomotion/gait.h"
#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/model/model.h"

namespace murosimf::locomotion {

class KeyframeTargets {
 public:
  /// Throws SetupError if the motion names a channel that the model does not have, or moves feet of a model without legs
  /// as leg.h describes them.
  KeyframeTargets(const Model& model, const KeyframeMotion& motion);

  /// `values`: one per column; `targets`: [rad | m] by object, all are written.
  void write(std::span<const double> values, std::span<double> targets) const noexcept;

  /// A joint that a column sets.
  struct JointSink {
    std::size_t column = 0;
    double sign = 1;
    int object = 0;
  };
  [[nodiscard]] const std::vector<JointSink>& joints() const noexcept { return joint_sinks_; }
  [[nodiscard]] bool moves_feet() const noexcept { return !foot_sinks_.empty(); }

 private:
  struct FootSink {
    std::size_t column = 0;
    double sign = 1;
    std::size_t side = 0;  // 0: left
    std::size_t axis = 0;  // x, y, z, pitch
  };
  using FootPlace = std::array<double, 4>;  // [m, m, m, rad] x, y, z, pitch from the stance

  void connect(const Model& model, const Channel& channel, std::size_t column);
  void place_feet(std::span<const double> values, std::span<double> targets) const noexcept;

  std::vector<double> rest_;  // [rad | m] by object: where joints are that the motion does not name
  std::vector<JointSink> joint_sinks_;
  std::vector<FootSink> foot_sinks_;
  std::array<Leg, 2> legs_;  // if feet are moved
  WalkParameters stance_;    // likewise
};

}  // namespace murosimf::locomotion
