/// new_name.h - level `new_name`: the base stays where it is, joints follow their targets.
///
/// Each step: joints follow their targets (joint_reference.h), the base rests, and direct kinematics places the links:
///
///     r_0 = const      R_0 = const      v_0 = w_0 = 0
///
/// Taking over a robot that moves (world/motion_level.h): its base stops at once, and its momentum is lost; pose and
/// joints stay as they are.
/// Source:  none. This place is for the equations of a level, and the paper or book that they are from.
/// Limits:  forces are ignored, also gravity: a robot stays in the air. It pushes others and is never pushed.
#pragma once

#include "murosimf/dynamics/joint_reference.h"
#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/world/motion_level.h"

namespace murosimf::dynamics {

class NewName final : public MotionLevel {
 public:
  static constexpr LevelTraits has{};  // .dynamic = true if contact forces move it

  explicit NewName(Setup& setup, const JointReferenceOptions& reference = {});

  [[nodiscard]] LevelTraits traits() const override { return has; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  [[nodiscard]] Momentum hand_over() noexcept override { return columns_.momentum(); }
  void take_over(const Momentum& momentum) override;

 private:
  void move_links() noexcept;

  // All state is in columns: further state of a level is a property of its own (motion_properties.h).
  Entity& entity_;
  PoseColumns columns_;
  JointReference reference_;
  double& dynamic_;
};

}  // namespace murosimf::dynamics
