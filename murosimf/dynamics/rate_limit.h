/// rate_limit.h - the largest rate to which a joint is driven (joint_rate_limit): the velocity limit of URDF.
///
/// A servo drives its joint up to the rate w with its full torque, and not beyond it; where another torque drives the joint
/// beyond w, the servo brakes with up to its stall torque T. In a step of h, with tau the largest torque of the servo law in the direction
/// s = +-1 (torque_line.h) and m = w - s qd the remaining rate, that becomes
///
///     m > 0:   b = min(tau / m, B)      tau' = b m - h b s qdd       tau, reduced by the joint's acceleration in the step
///     m <= 0:  b = min(T / -m, B)       tau' = b m - h b s qdd       it brakes
///
/// with B = T / (w / 50): so at the end of a step a joint that only its servo accelerates is never faster than w, whatever its
/// inertia; and where an obstacle stops it in the step, the torque is that of the servo law. Explicitly (h = 0), where a stiff
/// line is unstable, B = T / (w / 5).
/// Source: URDF XML specification, "joint", limit velocity; the line is the project's own.
#pragma once

#include <limits>

#include "murosimf/math/assert.h"
#include "murosimf/model/model.h"
#include "murosimf/model/servo.h"
#include "murosimf/multibody/servo/servo_motor.h"

namespace murosimf::dynamics {

struct RateLimit {
  double rate = std::numeric_limits<double>::infinity();  ///< [rad/s | m/s] w; infinite: none
  double most = std::numeric_limits<double>::infinity();  ///< [N m | N] T
  double line = 0;                                        ///< [N m s/rad | N s/m] B

  [[nodiscard]] bool limits() const { return rate < std::numeric_limits<double>::infinity(); }
};

/// The limit of a joint with a servo. For a servo of unlimited torque, the line is ten times as steep as its damping.
[[nodiscard]] RateLimit rate_limit(const Servo& servo, double rate);

/// Limit [rad/s | m/s] of a joint (an object of the model); infinite: none, as is a limit of 0. Throws SetupError for a negative one.
[[nodiscard]] double joint_rate_limit(const Model& model, int joint);
/// Largest rate [rad/s | m/s] of a joint: the no-load rate of its servo, at most joint_rate_limit; infinite: neither is given. Throws as above.
[[nodiscard]] double fastest_rate(const Model& model, int joint);

/// The line of the limit in one direction, where the motor has the limit `bound`; reduces the present torque `now`.
template <class S>
[[nodiscard]] multibody::TorqueLine<S> limit_rate_towards(double direction, const RateLimit& limit, const S& qd,
                                                          double dt, const multibody::TorqueLine<S>& bound, S& now) {
  MUROSIMF_ASSERT(dt >= 0 && (direction == 1.0 || direction == -1.0));
  const S line = dt > 0 ? limit.line : 0.1 * limit.line;
  const S margin = limit.rate - direction * qd;
  const auto slower = margin > S(0.0);
  const S tiny = 1e-9, away = select(slower, margin, -1.0 * margin);
  const S secant = select(slower, direction * bound.torque, S(limit.most)) / select(away < tiny, tiny, away);
  const S slope = select(secant < line, secant, line);
  const S most = slope * margin;
  const S present = direction * now, most_now = select(slower, line * margin, most);
  now = direction * select(present < most_now, present, most_now);
  const S inertia = dt * slope;
  return {direction * most, select(bound.inertia < inertia, inertia, bound.inertia)};
}

/// Limits the torque of a servo that is switched on.
template <class S>
void limit_rate(const RateLimit& limit, const S& enabled, const S& qd, double dt, multibody::MotorTorque<S>& torque) {
  if (!limit.limits()) return;
  const S when_off = torque.now;
  torque.ceiling = limit_rate_towards(1.0, limit, qd, dt, torque.highest, torque.now);
  torque.floor = limit_rate_towards(-1.0, limit, qd, dt, torque.lowest, torque.now);
  const auto is_off = enabled == S(0.0);
  torque.now = select(is_off, when_off, torque.now);
  torque.ceiling.torque = select(is_off, S(torque.unbounded), torque.ceiling.torque);
  torque.floor.torque = select(is_off, S(-torque.unbounded), torque.floor.torque);
}

}  // namespace murosimf::dynamics
