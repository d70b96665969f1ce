/// keyframe_pose.h - the joint targets of a key-frame motion on one model.
///
/// If the motion moves feet, both legs follow by inverse kinematics (leg.h) from the stance in which the walk engine stands (gait.h): x
/// forward, y to the left, z up, each in the level frame of the pelvis; angles that the motion gives to leg joints come on top.
#pragma once

#include <array>
#include <vector>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/keyframe_motion.h"

namespace murosimf::locomotion {

class KeyframePose {
 public:
  /// Throws SetupError if the motion names a channel that the model does not have, or moves feet of a model without legs
  /// as leg.h describes them.
  KeyframePose(const Model& model, const KeyframeMotion& motion);

  [[nodiscard]] double duration() const noexcept { return duration_; }  ///< [s]
  [[nodiscard]] const KeyframeMotion& motion() const noexcept { return motion_; }

  /// Targets [rad | m] by object at `time` [s] after the start; those of joints that the motion does not name are 0.
  void write(double time, std::span<double> targets) noexcept;

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
    std::size_t axis = 0;  // x, y, z, pitch
  };
  using FootPlace = std::array<double, 4>;  // [m, m, m, rad] x, y, z, pitch from the stance

  void connect(const Model& model, const Channel& channel, std::size_t column);
  void place_feet(std::span<double> targets) noexcept;

  KeyframeMotion motion_;
  double duration_;  // [s]
  std::vector<JointSink> joint_sinks_;
  std::vector<FootSink> foot_sinks_;
  std::array<Leg, 2> legs_;     // if feet are moved
  WalkParameters stance_;       // likewise
  std::vector<double> values_;  // by column
};

}  // namespace murosimf::locomotion
