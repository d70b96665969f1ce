/// gear_friction.h - the largest torque of the dry friction in a servo's gear.
///
/// It is a budget, not a force: friction takes the value that stops the joint within the step, limited to the budget.
/// Sticking, breaking away and sliding follow from that one rule. With tau_m the motor's torque and tau_e the load, which is
/// the sum of all torques except those of motor and own friction, both in the joint's direction,
///
///     F = K_c + |K_m tau_m - K_e tau_e| + s (K_cs + |K_ms tau_m - K_es tau_e| + Q),   s = exp(-|w/v_s|^alpha)
///     Q = K_eq tau_e^2 if |tau_m| >= |tau_e|, else K_mq tau_m^2; 0 unless tau_m and tau_e have opposite signs
///
/// The viscous part K_v |w| is not included: it is linear, and belongs to the implicit side of a step. Models M1 to M6 are
/// special cases: M1 K_c; M2 adds K_cs; M3 and M4 have K_m = K_e and K_ms = K_es; M5 has all but Q; M6 all.
///
/// Source: Duclusaud, Passault, Padois, Ly, "Extended Friction Models for the Physics Simulation of Servo Actuators",
/// ICRA 2025. The paper has Q always; the authors' program (github.com/Rhoban/bam), with which the published parameters were
/// fitted, only against a load. This implementation follows the program, so the published parameters apply.
#pragma once

#include <array>

#include "murosimf/math/pack.h"
#include "murosimf/model/servo.h"

namespace murosimf::multibody {

/// F [N m], at least 0, for the joint's rate [rad/s] and torques [N m] at the beginning of a step. The numbers of
/// `friction` hold for all lanes. The exponent alpha is limited to 0.5 to 10; a rate v_s below 0.01 rad/s counts as
/// 0.01 rad/s, and 0 disables the Stribeck part.
template <class S>
[[nodiscard]] S dry_friction(const GearFriction& friction, const S& rate, const S& motor_torque,
                             const S& external_torque) noexcept;

/// s of the same equation, 0 to 1; 0 for a gear without Stribeck part.
template <class S>
[[nodiscard]] S stribeck_share(const GearFriction& friction, const S& rate) noexcept;

/// F for a given s.
template <class S>
[[nodiscard]] S dry_friction_with_share(const GearFriction& friction, const S& share, const S& motor_torque,
                                        const S& external_torque) noexcept;

/// Computes s of many joints, eight at a time in lanes: a single evaluation is bound by latency. The bits are those of
/// stribeck_share.
class StribeckShares {
 public:
  /// `share` is written immediately or by write(), unless the gear has no Stribeck part.
  void add(const GearFriction& friction, double rate, double& share) noexcept;
  /// Writes the shares that have been added and not yet written.
  void write() noexcept;

 private:
  Pack8 ratio_ = 0.0, exponent_ = 1.0;  // |w|/v_s, alpha
  std::array<double*, Pack8::lanes> shares_{};
  int count_ = 0;
};

}  // namespace murosimf::multibody
