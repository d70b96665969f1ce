/// gear_friction.h - the largest torque that the dry friction of a servo's gear can muster.
///
/// A budget, not a force: friction takes what is needed to stop the joint within the step, at most this. Sticking,
/// breaking away and sliding follow from that one rule. With tau_m the motor's torque and tau_e all that the joint feels
/// except motor and own friction, both in the joint's direction,
///
///     F = K_c + |K_m tau_m - K_e tau_e| + s (K_cs + |K_ms tau_m - K_es tau_e| + Q),   s = exp(-|w/v_s|^alpha)
///     Q = K_eq tau_e^2 if |tau_m| >= |tau_e|, else K_mq tau_m^2; 0 unless tau_m and tau_e pull against each other
///
/// The viscous part K_v |w| is not in it: it is linear, and belongs to the implicit side of a step. Models M1 to M6 are
/// special cases: M1 K_c; M2 adds K_cs; M3 and M4 have K_m = K_e and K_ms = K_es; M5 has all but Q; M6 all.
///
/// Source: Duclusaud, Passault, Padois, Ly, "Extended Friction Models for the Physics Simulation of Servo Actuators",
/// ICRA 2025. Their paper has Q always, their program (github.com/Rhoban/bam), by which the published parameters were
/// fitted, only against a load; so has this one: numbers mean what they meant where they come from.
#pragma once

#include <array>

#include "murosimf/math/pack.h"
#include "murosimf/model/servo.h"

namespace murosimf::multibody {

/// F [N m], at least 0, for the joint's rate [rad/s] and torques [N m] at the beginning of a step. The numbers of
/// `friction` hold for all lanes. The exponent alpha counts as one from 0.5 to 10, a rate v_s below 0.01 rad/s as
/// 0.01 rad/s, but 0 takes the Stribeck part away.
template <class S>
[[nodiscard]] S dry_friction(const GearFriction& friction, const S& rate, const S& motor_torque,
                             const S& external_torque) noexcept;

/// s of the same, 0 to 1; 0 for a gear without Stribeck part.
template <class S>
[[nodiscard]] S stribeck_share(const GearFriction& friction, const S& rate) noexcept;

/// F, where s is known.
template <class S>
[[nodiscard]] S dry_friction_with_share(const GearFriction& friction, const S& share, const S& motor_torque,
                                        const S& external_torque) noexcept;

/// Computes s of many joints, eight in lanes: one alone waits for each of its operations in turn. The bits are those of
/// stribeck_share.
class StribeckShares {
 public:
  /// `share` is written now or by write(), unless the gear has no Stribeck part.
  void add(const GearFriction& friction, double rate, double& share) noexcept;
  /// Those that have been added and not yet written.
  void write() noexcept;

 private:
  Pack8 ratio_ = 0.0, exponent_ = 1.0;  // |w|/v_s, alpha
  std::array<double*, Pack8::lanes> shares_{};
  int count_ = 0;
};

}  // namespace murosimf::multibody
