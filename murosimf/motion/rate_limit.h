/// rate_limit.h - the largest rate to which a joint is driven (joint_rate_limit): what URDF calls its velocity.
///
/// A servo drives its joint up to the rate w with all the torque that it has, and not beyond it; where something else drives the joint
/// beyond w, the servo brakes with up to its stall torque T. In a step of h, with tau the most that the servo law makes in the direction
/// s = +-1 (torque_line.h) and m = w - s qd what is left of the rate, that becomes
///
///     m > 0:   b = min(tau / m, B)      tau' = b m - h b s qdd       tau, and less for what the joint gets faster in the step
///     m <= 0:  b = min(T / -m, B)       tau' = b m - h b s qdd       it brakes
///
/// with B = T / (w / 50): so at the end of a step a joint that its servo alone accelerates is never faster than w, whatever its
/// inertia; and where something else stops it in the step, the torque is what the servo law allows. Explicitly (h = 0), where a stiff
/// line does not hold, B = T / (w / 5).
/// Source: URDF XML specification, "joint", limit velocity; the line is the project's own.
#pragma once

#include <limits>

#include "murosimf/model/model.h"
#include "murosimf/model/servo.h"
#include "murosimf/multibody/servo_motor.h"

namespace murosimf::motion {

struct RateLimit {
  double rate = std::numeric_limits<double>::infinity();  ///< [rad/s | m/s] w; infinite: none
  double most = std::numeric_limits<double>::infinity();  ///< [N m | N] T
  double line = 0;                                        ///< [N m s/rad | N s/m] B

  [[nodiscard]] bool limits() const { return rate < std::numeric_limits<double>::infinity(); }
};

/// Of a joint with a servo. Of one of unlimited torque, the line is ten times as steep as its damping.
[[nodiscard]] RateLimit rate_limit(const Servo& servo, double rate);

/// [rad/s | m/s] of a joint (an object of the model); infinite: none, as is a limit of 0. Throws SetupError for a negative one.
[[nodiscard]] double joint_rate_limit(const Model& model, int joint);
/// [rad/s | m/s] that a joint can come to: what its servo turns without load, at most joint_rate_limit; infinite: neither is known. Throws as above.
[[nodiscard]] double fastest_rate(const Model& model, int joint);

/// The line of the limit in one direction, where the motor has the `bound`; and what it makes now.
template <class S>
[[nodiscard]] multibody::TorqueLine<S> limit_rate_towards(double direction, const RateLimit& limit, const S& qd,
                                                          double dt, const multibody::TorqueLine<S>& bound, S& now) {
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

/// What is left of the torque of a servo that is switched on.
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

}  // namespace murosimf::motion
