/// friction_solver.h - the articulated-body algorithm with dry friction in the joints.
///
/// Friction of a joint is bounded by a budget F (gear_friction.h, plus the joint's own Coulomb friction): its torque is that
/// which stops the joint within the step, limited to F. With the notation of articulated_body.h, and the torque tau and
/// inertia A of all other torques of the joint,
///
///     tau_e = -s . pA - U . a'_p           load: all torques except those of the joint's own drive
///     p = (D qd) / h + tau + tau_e         determines the rate at the end of the step: D (qd + h qdd) = h p
///     |p| < F: it sticks, qdd = -qd / h;   otherwise it slides, tau -= sign(p) F
///
/// so a single joint ends at the rate sign(p) max(0, |p| - F) h / D. The motor's part of tau and A is the line
/// (torque_line.h) that it follows at the end of the step. The part of a range end is its line if the joint would be beyond
/// the end by then; with the stop added, the motor's line is chosen again. a'_p is known only after the sweep: the sweep
/// takes that of the last pass. If with the true a'_p the friction of some joint is off by more than a quarter of F, the
/// pass has to be repeated; with a smaller error, the next step corrects it. In a repeated pass a sliding joint has the
/// torque -b (rate after the step), b = F over its predicted final rate, to which what a coupling takes along (coupling_forces.h) counts: if the number of passes is exhausted before all
/// joints agree, friction has not driven any joint.
///
/// Inside an island of touching robots (collision/contact_laws/impulse_response.h) there is one pass, and contact forces are added
/// afterwards: tau_e is that of the preceding step, and sliding joints have the same damper.
///
/// A sticking joint has the inertia 1e30 kg m^2: loads are transmitted to its parent as through a rigid link.
/// Source: Duclusaud, Passault, Padois, Ly, "Extended Friction Models for the Physics Simulation of Servo Actuators",
/// ICRA 2025 (budget); active set over the whole tree: the project's own.
#pragma once

#include <span>

#include "murosimf/model/servo.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/servo/torque_line.h"

namespace murosimf::multibody {

template <class S>
struct FrictionalJoint {
  const GearFriction* gear = nullptr;  ///< of the servo, without its viscous part; null: no gear friction; in
  double coulomb = 0;                  ///< [N m | N] friction of the joint itself; in
  S rate{};                            ///< qd [rad/s | m/s]; in
  MotorTorque<S> motor;                ///< of the servo; in
  RangeEnd<S> end;                     ///< of its range; in
  S torque{};                          ///< [N m | N] all other torques except dry friction; in
  S inertia{};                         ///< [kg m^2 | kg] all other inertia; in
  S coupled{};                         ///< [kg m^2 | kg] inertia that its coupling takes along; in
  TorqueLine<S> line;                  ///< line that the motor follows; out
  S D{};                               ///< [kg m^2 | kg] inertia of the joint with that line; out
  S load{};                            ///< tau_e [N m | N]; in for `Loads::of_last_step`; out
  S share{};                           ///< s of gear_friction.h at this rate; out
  S own_load{};                        ///< -s . pA [N m | N]; out
  S drive{};                           ///< p - tau_e [N m | N]; out
  S budget{};                          ///< F [N m | N]; out
  S direction{};                       ///< -1 or 1 of a sliding joint, 0 of a sticking one; out
};

/// Source of tau_e, which also selects the friction of sliding joints: F in the first pass, a damper in all others.
enum class Loads { of_last_pass, of_repeated_pass, of_last_step };

/// Sweeps from leaves to base, like sweep_to_base. The bodies' `acceleration` is that of the last pass; `torque` and
/// `added_inertia` are not used. `dt` [s] > 0.
template <class S>
void sweep_with_friction(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies,
                         std::span<FrictionalJoint<S>> joints, Loads loads, double dt) noexcept;

/// Sweeps from base to leaves, like `accelerate`. Returns the number of joints whose decision is wrong, lane by lane; where
/// it is not 0, the pass has to be repeated.
template <class S>
[[nodiscard]] S accelerate_with_friction(const Tree& tree, std::span<const LinkMotion<S>> links,
                                         std::span<ArticulatedLink<S>> bodies, std::span<FrictionalJoint<S>> joints,
                                         const Twist<S>& base) noexcept;

/// The same count for the present loads (`load`), if these have changed.
template <class S>
[[nodiscard]] S wrong_decisions(std::span<const FrictionalJoint<S>> joints) noexcept;

/// Whether each motor follows the line that belongs to the present load (`load`), after a step of `dt` [s].
[[nodiscard]] bool follow_their_lines(std::span<const FrictionalJoint<double>> joints, double dt) noexcept;

/// Whether the motor is at none of its limits in this step; in lanes: where.
template <class S>
[[nodiscard]] auto is_free(const FrictionalJoint<S>& joint) noexcept {
  return joint.line == joint.motor.free;
}

/// Friction torque [N m | N] at the end of the step, for the final load (`load`).
template <class S>
[[nodiscard]] S friction_torque(const FrictionalJoint<S>& joint) noexcept {
  const S all = -(joint.drive + joint.load);
  return select(joint.direction == S(0.0), all, -(joint.direction * joint.budget));
}

}  // namespace murosimf::multibody
