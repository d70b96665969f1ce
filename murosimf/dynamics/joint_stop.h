/// joint_stop.h - the ends of a joint's range, where the joint is moved by forces: a spring and a damper, implicit as the
/// servo is, wherever the step would otherwise end beyond (multibody/servo/torque_line.h):
///
///     torque = k (end - q - h qd) - d qd,   k = max(T / 0.25 degree, J (800 rad/s)^2),   d = k * 5 ms
///
/// with T the larger of the servo's stall torque and the robot's weight times 0.1 m (T / 0.5 mm with its weight, for a slider), and J the
/// inertia that the joint moves while all joints are at zero, with the joints that follow it (mimic_joints.h): twice the kinetic energy
/// of all links at a rate of 1 of the joint and of their ratios of its followers. So a fallen robot bends its stops by less than a degree,
/// and a limb that arrives with the rate w, overdamped, overshoots by w * 0.28 ms at most and does not bounce: with the bend due to its
/// servo, up to 10 mrad at 20 rad/s.
/// Explicit steps, which would be unstable with that, have k = T / 0.25 degree and d = k * 5 ms with a servo; without one
/// k = max(T / 0.25 degree, J (200 rad/s)^2) and d = k * 10 ms.
/// Source: damped oscillator; numbers are the project's own.
#pragma once

#include <span>

#include "murosimf/dynamics/mimic_joints.h"
#include "murosimf/model/model.h"

namespace murosimf::dynamics {

struct JointStop {
  struct Spring {
    double stiffness = 0;  ///< [N m/rad | N/m] k
    double damping = 0;    ///< [N m s/rad | N s/m] d
  };
  double lowest = 0, highest = 0;  ///< [rad | m]
  Spring implicit, explicitly;

  [[nodiscard]] bool stops() const { return implicit.stiffness > 0; }
};

/// The stop of a joint (an object of the model) that can move from `lowest` to `highest` [rad | m]; no ends if these are infinite. `coupled`:
/// joints that follow others.
[[nodiscard]] JointStop joint_stop(const Model& model, int joint, double lowest, double highest,
                                   std::span<const MimicJoints::Pair> coupled = {});

}  // namespace murosimf::dynamics
