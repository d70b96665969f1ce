/// servo_pendulum.h - a servo that swings a pendulum: the test bench on which servos are identified.
///
/// Everything on the output side of the gear; the pendulum hangs down at q + q_0 = 0. With the firmware's duty
/// u = clamp(g (goal - q), +-u_max), g its gain in duty per angle,
///
///     (J + J_a) w' = tau_m + tau_e + friction         J = m l^2 + m_a l^2/3
///     tau_m = (k_t/R) u V - (k_t^2/R) w               0 while the bridge is open: only friction brakes
///     tau_e = -(m + m_a/2) g_0 l sin(q + q_0)
///
/// A current limit I clamps the duty, as firmware does: u is clamped to (k_t w +- R I)/V first, to +-u_max last. One step is
/// linearly implicit in the rate: back-EMF, viscous friction and, while the duty is not clamped, the gain go to the left,
///
///     D = J + J_a + h (k_t^2/R + K_v) + h^2 (k_t/R) V g,   p = (J + J_a) w + h (tau_m0 + tau_e)
///     w+ = sign(p) max(0, |p| - h F)/D,                    q+ = q + h w+
///
/// with tau_m0 the motor's torque at the present angle without back-EMF, and F the budget of dry friction
/// (gear_friction.h). Stopping is exact: w+ = 0, without creep. First order in h.
///
/// Source: textbook permanent-magnet DC motor; pendulum, controller and order of limits as on the bench of
/// Duclusaud et al., ICRA 2025 (github.com/Rhoban/bam).
#pragma once

#include "murosimf/model/servo.h"

namespace murosimf::multibody {

/// The servo: equal in all lanes.
struct BenchServo {
  double torque_constant = 0;  ///< [N m/A = V s/rad] k_t
  double resistance = 1;       ///< [ohm] R of winding and driver
  double rotor_inertia = 0;    ///< [kg m^2] J_a
  double duty_limit = 1;       ///< [1] u_max
  double current_limit = 0;    ///< [A] I; 0: none
  double encoder_offset = 0;   ///< [rad] q_0: the angle of the pendulum where the encoder reads zero
  GearFriction friction;
};

/// The load of the servo, and its firmware's gain.
template <class S>
struct Bench {
  S inertia;  ///< [kg m^2] J of the pendulum about the axis
  S weight;   ///< [N m] torque that holds the pendulum level: (m + m_a/2) g_0 l
  S gain;     ///< [1/rad] g: duty per angle
};

/// Input of the servo during a step.
template <class S>
struct BenchInput {
  S goal;     ///< [rad] of the encoder
  S voltage;  ///< [V] > 0
  S enabled;  ///< [1] 1: the motor is driven, 0: the bridge is open
};

template <class S>
struct BenchState {
  S position{};  ///< [rad] q, as the encoder reads it
  S rate{};      ///< [rad/s] w
};

/// Advances `state` by `h` [s] > 0.
template <class S>
void advance(const BenchServo& servo, const Bench<S>& bench, const BenchInput<S>& input, double h,
             BenchState<S>& state) noexcept;

}  // namespace murosimf::multibody
