/// passive_joint.h - passive torques of a joint, independent of its servo: a damper, a spring and Coulomb friction.
///
///     torque = -d qd - k s,   s = q - rest below rest, q - rest - slack above rest + slack, 0 between them
///
/// Properties joint_damping, joint_stiffness, joint_spring_reference and joint_spring_slack.
/// Source of the dead band: MuJoCo documentation, XML reference, "tendon", springlength.
#pragma once

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/model.h"

namespace murosimf::properties {

inline constexpr Property<double> joint_spring_slack{
    {"joint_spring_slack", "rad | m", "joint", "from that position up, where its spring is slack, too"}};

}  // namespace murosimf::properties

namespace murosimf::dynamics {

struct PassiveJoint {
  double damping = 0;    ///< [N m s/rad | N s/m] d
  double stiffness = 0;  ///< [N m/rad | N/m] k
  double rest = 0;       ///< [rad | m] where the spring is slack
  double slack = 0;      ///< [rad | m] up to this much beyond, too

  /// [N m | N] at a position and rate.
  [[nodiscard]] double torque(double q, double qd) const noexcept { return torque_as<double>(q, qd); }
  template <class S>
  [[nodiscard]] S torque_as(const S& q, const S& qd) const noexcept {
    return -damping * qd - stiffness * stretch_as(q);
  }
  /// [rad | m] s
  template <class S>
  [[nodiscard]] S stretch_as(const S& q) const noexcept {
    const S above = q - rest;
    if (!(slack > 0)) return above;
    const S beyond = above - slack;
    return select(above < S(0.0), above, select(beyond > S(0.0), beyond, S(0.0)));
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
