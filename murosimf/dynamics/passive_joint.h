/// passive_joint.h - passive torques of a joint, independent of its servo: a damper, a spring and Coulomb friction.
///
///     torque = -d qd - k (q - rest)
///
/// Properties joint_damping, joint_stiffness and joint_spring_reference.
#pragma once

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/model/model.h"

namespace murosimf::dynamics {

struct PassiveJoint {
  double damping = 0;    ///< [N m s/rad | N s/m] d
  double stiffness = 0;  ///< [N m/rad | N/m] k
  double rest = 0;       ///< [rad | m] where the spring is slack

  /// [N m | N] at a position and rate.
  [[nodiscard]] double torque(double q, double qd) const noexcept { return torque_as<double>(q, qd); }
  template <class S>
  [[nodiscard]] S torque_as(const S& q, const S& qd) const noexcept {
    return -damping * qd - stiffness * (q - rest);
  }
};

/// The passive torques of a joint (an object of the model). Throws SetupError if its spring is impossible.
[[nodiscard]] PassiveJoint passive_joint(const Model& model, int joint);

/// Coulomb friction as a damper that depends on the joint's rate: b [N m s/rad | N s/m] of the friction -b qd that is F [N m | N] against
/// the motion, and decreases linearly to zero below 0.05 rad/s (m/s). Evaluated at the beginning of a step, so a loaded joint creeps with
/// the rate 0.05 rad/s times its load's share of F.
[[nodiscard]] inline double coulomb_damping(double friction, double rate) {
  MUROSIMF_ASSERT(friction >= 0);
  constexpr double slow = 0.05;  // [rad/s | m/s]
  return friction / std::max(std::abs(rate), slow);
}

}  // namespace murosimf::dynamics
