/// servo_motor.h - firmware and motor of a servo: the torque for a target, at a supply voltage and a temperature.
///
/// Everything on the output side of the gear. With the nominal numbers of model/servo.h (stall torque T, no-load rate
/// w_0, gain kp, duty limit u), the supply voltage s as a share of its nominal value, and the conductance c of the
/// winding as a share of that at 25 C:
///
///     e = target - q, in whole steps of the encoder, reduced by the dead band firmware, P only
///     tau_0 = (kp e + k_d (w_t - w) + tau_f) s c                              duty cycle times stall torque T s c
///     tau_m = tau_0 - d w,  d = c T/w_0                                       back-EMF: the speed-torque line
///
/// The firmware can only move the duty, so the current limit clamps tau_0 to d w +- limit first and the duty limit, +-u T s c, last:
/// at high rates the current is what it is. k_d, w_t and tau_f are 0 until software sets them (firmware that takes the derivative of the position alone).
/// With torque switched off the bridge is open: tau_m is 0, nothing brakes.
/// In a step of h, tau_m decreases with the acceleration by h d, and by h^2 kp s c more while no limit clamps the duty; at the
/// current limit it is constant. The joint's inertia decides which of these holds (torque_line.h). The encoder's steps count by
/// their mean slope.
///
/// Heat: C dT/dt = R i^2 - (T - T_a)/R_th with R = R_25/c, 1/c = 1 + 0.0039/K (T - 25 C), i = tau_m/k_t. Above a
/// temperature the firmware lowers the current limit linearly, to zero at a higher one.
/// Source: textbook permanent-magnet DC motor (stall = k_t V/R, stall/no_load = k_t^2/R) and one thermal node;
/// temperature coefficient of copper.
#pragma once

#include <limits>

#include "murosimf/math/assert.h"
#include "murosimf/math/inline.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/servo.h"
#include "murosimf/multibody/servo/torque_line.h"

namespace murosimf::multibody {

/// Numbers of a servo of law dc_motor, the same for all lanes.
struct ServoMotor {
  ServoMotor() = default;
  explicit ServoMotor(const Servo& servo);

  double gain = 0;             ///< [N m/rad] kp
  double line = 0;             ///< [N m s/rad] T/w_0
  double most = 0;             ///< [N m] u T
  double torque_limit = 0;     ///< [N m] by the current limit; infinite: none
  double warm_limit = 0;       ///< [N m] torque limit that derating scales
  double encoder_step = 0;     ///< [rad] 0: exact
  double dead_band = 0;        ///< [rad]
  double torque_constant = 0;  ///< [N m/A] k_t; 0: unknown
  double resistance = 0;       ///< [ohm] R_25
  ServoHeat heat;
};

/// Input of a motor in one step: target, state, supply and limits.
template <class S>
struct MotorInput {
  S target{};           ///< [rad]
  S q{};                ///< [rad] of the output
  S rate{};             ///< [rad/s] w of the output
  S supply = 1.0;       ///< [1] s
  S conductance = 1.0;  ///< [1] c
  S allowed = 1.0;      ///< [1] share of the torque that the temperature permits
  S enabled = 1.0;      ///< [1] 0: torque is switched off
  S gain = 1.0;         ///< [1] factor of kp that software has set
  S damping{};          ///< [N m s/rad] k_d of software: velocity gain beyond the servo's own
  S limit = std::numeric_limits<double>::infinity();  ///< [N m] of the motor, by software
  S target_rate{};                                    ///< [rad/s] w_t that the velocity gain drives to, by software
  S feed_forward{};                                   ///< [N m] tau_f, by software
};

/// x limited to the range from low to high; NaN stays NaN.
template <class S>
[[nodiscard]] MUROSIMF_INLINE S clamped(const S& x, const S& low, const S& high) {
  const S cut = select(x < low, low, x);
  return select(cut > high, high, cut);
}

/// An angle [rad] rounded to whole encoder steps [rad].
template <class S>
[[nodiscard]] MUROSIMF_INLINE S in_whole_steps(double step, const S& angle) {
  if (step <= 0) return angle;
  // adding and subtracting round_bias rounds to the nearest integer in every lane without a library call
  return ((angle * (1 / step) + round_bias) - round_bias) * step;
}

/// Position error [rad] that the firmware acts on.
template <class S>
[[nodiscard]] MUROSIMF_INLINE S position_error(double encoder_step, double dead_band, const S& target, const S& q) {
  const S error = in_whole_steps(encoder_step, target) - in_whole_steps(encoder_step, q);
  if (dead_band <= 0) return error;  // without a dead band the bits of the error must not change
  return error - clamped<S>(error, -dead_band, dead_band);
}

/// Torque of a servo of law dc_motor, for a step of h [s]; h = 0 gives the explicit torque of this instant.
template <class S>
[[nodiscard]] MotorTorque<S> motor_torque(const ServoMotor& motor, const MotorInput<S>& in, double h) {
  MUROSIMF_ASSERT(h >= 0);
  const S strength = in.supply * in.conductance, d = motor.line * in.conductance;
  const S gain = motor.gain * strength * in.gain, most = motor.most * strength, back_emf = d * in.rate;
  const S braking = in.damping * strength;
  const S error = position_error(motor.encoder_step, motor.dead_band, in.target, in.q);
  S slope = gain;
  if (motor.dead_band > 0) slope = select(error == S(0.0), S(0.0), gain);
  const S ahead = (h * slope) * in.rate;
  const S wanted = gain * error - ahead - braking * (in.rate - in.target_rate) + strength * in.feed_forward;
  const S cool = select(in.allowed < S(1.0), in.allowed * motor.warm_limit, S(motor.torque_limit));
  const S range = select(in.limit < cool, in.limit, cool);
  const S high_current = back_emf + range, low_current = back_emf - range;
  const S high = clamped<S>(high_current, -most, most), low = clamped<S>(low_current, -most, most);
  const S given = clamped<S>(wanted, low, high);

  const S now = select(given == wanted, wanted + ahead, given) - back_emf;
  const S line = h * d;
  const auto off = in.enabled == S(0.0);
  const bool any_off = any(off);
  const auto when_on = [&](const S& number) { return any_off ? select(off, S(0.0), number) : number; };
  return {when_on(now),
          {when_on(wanted - back_emf), when_on(line + (h * h) * slope + h * braking)},
          {when_on(high - back_emf), when_on(select(high == high_current, S(0.0), line))},
          {when_on(low - back_emf), when_on(select(low == low_current, S(0.0), line))}};
}

/// Conductance c of a winding at a temperature [C].
template <class S>
[[nodiscard]] S winding_conductance(const S& temperature) {
  constexpr double per_kelvin = 0.0039, reference = 25;
  return 1.0 / (1.0 + per_kelvin * (temperature - reference));
}

/// Share of the torque that the firmware permits at a temperature [C]: 1 while it is cool, 0 from the limit on.
template <class S>
[[nodiscard]] S allowed_share(const ServoHeat& heat, const S& temperature) {
  if (heat.derating_temperature <= 0) return 1.0;
  MUROSIMF_ASSERT(heat.temperature_limit > heat.derating_temperature);
  const S share = (heat.temperature_limit - temperature) * (1 / (heat.temperature_limit - heat.derating_temperature));
  return clamped<S>(share, 0.0, 1.0);
}

/// Temperature [C] after a step of h [s] > 0 in which the motor made `torque` [N m]: implicit Euler.
template <class S>
[[nodiscard]] S next_temperature(const ServoMotor& motor, const S& temperature, const S& torque, double h) {
  const ServoHeat& heat = motor.heat;
  MUROSIMF_ASSERT(h > 0 && heat.heat_capacity > 0 && heat.thermal_resistance > 0 && motor.torque_constant > 0);
  const S i = torque * (1 / motor.torque_constant);
  const S losses = motor.resistance * i * i / winding_conductance(temperature);
  const double share = h / heat.heat_capacity, cooling = 1 / heat.thermal_resistance;
  return (temperature + share * (losses + heat.ambient_temperature * cooling)) * (1 / (1 + share * cooling));
}

}  // namespace murosimf::multibody
