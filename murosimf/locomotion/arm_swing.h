/// arm_swing.h - arms that swing against the legs: what the legs turn the body about the vertical, the standing foot need not hold by friction.
///
/// What hangs at a hip or shoulder that turns by q about the axis to the left has, about the vertical through the robot, in its stance,
///     L_z = J dq/dt,   J = -sum m_i y_i (z_i - z_joint)
/// with masses m_i [kg] at y_i, z_i [m]. A leg swings by Q cos(phase), Q = v T_s / (2 h) at the speed v [m/s], with T_s [s] that a foot stands and h
/// [m] the height of the hips; the arm of its side by as much as makes the sum of both zero, times `arm_swing`, the other way.
/// Source: textbook mechanics. What it is good for: Collins, Adamczyk, Kuo, "Dynamic arm swinging in human walking", Proc. R. Soc. B 276
/// (2009), with measurements of the moment that the ground must give.
#pragma once

#include <array>
#include <span>

#include "murosimf/locomotion/gait.h"
#include "murosimf/model/model.h"

namespace murosimf::locomotion {

class ArmSwing {
 public:
  /// Throws SetupError if arms shall swing and the model has none that hang, or point up, in its stance.
  ArmSwing(const Model& model, const std::array<Leg, 2>& legs, const WalkParameters& parameters);

  /// Shoulders of a walk with `phase` [rad], `amplitude` [1] and `speed` [m/s] forward, into `targets` [rad] by object; without a swing nothing.
  void write(double phase, double amplitude, double speed, std::span<double> targets) const noexcept;

 private:
  struct Shoulder {
    int joint = 0;    // object
    double rest = 0;  // [rad]
    double gain = 0;  // [rad/(m/s)] at phase 0, when the left foot is ahead
  };
  bool swings_;
  std::array<Shoulder, 2> shoulders_{};  // left first
};

}  // namespace murosimf::locomotion
