/// joint_stop.h - the ends of a joint's range, where the joint is moved by forces: a spring and a damper, implicit as the
/// servo is,
///
///     torque = k (end - q - h qd) - d qd
///
/// With a servo, k = T / 0.25 degree (T / 0.5 mm) and d = k * 5 ms, with T the larger of the servo's stall torque and
/// the robot's weight times 0.1 m (its weight, for a slider): a fallen robot bends its stops by less than a degree.
/// A joint without servo has no gear that takes a blow. Its k is at least J (200 rad/s)^2, with J the inertia that it
/// moves, and d = k * 10 ms: at least critically damped, so a limb that arrives at the rate w does not bounce and goes
/// at most w / (e 200 rad/s) = w * 1.8 ms too far.
/// Source: critically damped oscillator; numbers are the project's own.
#pragma once

#include "murosimf/model/model.h"

namespace murosimf::motion {

struct JointStop {
  double lowest = 0, highest = 0;  ///< [rad | m]
  double stiffness = 0;            ///< [N m/rad | N/m] k; 0: no ends
  double damping = 0;              ///< [N m s/rad | N s/m] d
};

/// Of a joint (an object of the model) that can stand from `lowest` to `highest` [rad | m]; no ends if these are infinite.
[[nodiscard]] JointStop joint_stop(const Model& model, int joint, double lowest, double highest);

}  // namespace murosimf::motion
