/// friction_solver.h - the articulated-body algorithm with joints that friction holds or brakes.
///
/// Friction of a joint is a budget F (gear_friction.h, plus the joint's own Coulomb friction): it takes what is needed to stop the
/// joint within the step, at most F. With the notation of articulated_body.h, and the torque tau and inertia A of
/// everything else that acts in the joint,
///
///     tau_e = -s . pA - U . a'_p           all that the joint feels besides its own drive
///     p = (D qd) / h + tau + tau_e         what would make the rate at the end of the step: D (qd + h qdd) = h p
///     |p| < F: it sticks, qdd = -qd / h;   else it slides, tau -= sign(p) F
///
/// so one joint alone ends at the rate sign(p) max(0, |p| - F) h / D. What tau and A have of a motor is the line (torque_line.h) that it
/// follows at that end, and what they have of an end of the joint's range is its line where the joint would be beyond it by then: from
/// without a stop to with it, the motor's line is decided anew. a'_p is not known before the sweep is over: the sweep takes that of the last pass. If with the true a'_p friction of some joint is off by more than a quarter of F, the pass has to be
/// repeated; with less, the next step decides better. In a repeated pass a sliding joint feels -b (rate after the step), b = F
/// over the rate at which it should end: should passes run out before all joints agree, friction has driven none.
///
/// Inside an island of touching robots (collision/impulse_response.h) there is one pass, and forces of contacts come
/// afterwards: tau_e is that of the step before, and sliding joints feel the same damper.
///
/// A sticking joint counts as one of the inertia 1e30 kg m^2: what acts on it passes on to its parent as through a rigid link.
/// Source: Duclusaud, Passault, Padois, Ly, "Extended Friction Models for the Physics Simulation of Servo Actuators",
/// ICRA 2025 (budget); active set over the whole tree: the project's own.
#pragma once

#include <span>

#include "murosimf/model/servo.h"
#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/torque_line.h"

namespace murosimf::multibody {

template <class S>
struct FrictionalJoint {
  const GearFriction* gear = nullptr;  ///< of the servo, without its viscous part; null: none; in
  double coulomb = 0;                  ///< [N m | N] friction of the joint itself; in
  S rate{};                            ///< qd [rad/s | m/s]; in
  MotorTorque<S> motor;                ///< of the servo; in
  RangeEnd<S> end;                     ///< of its range; in
  S torque{};                          ///< [N m | N] of all else but dry friction; in
  S inertia{};                         ///< [kg m^2 | kg] of all else; in
  TorqueLine<S> line;                  ///< that the motor follows; out
  S D{};                               ///< [kg m^2 | kg] inertia of the joint with that line; out
  S load{};                            ///< tau_e [N m | N]; in for `Loads::of_last_step`; out
  S share{};                           ///< s of gear_friction.h at this rate; out
  S own_load{};                        ///< -s . pA [N m | N]; out
  S drive{};                           ///< p - tau_e [N m | N]; out
  S budget{};                          ///< F [N m | N]; out
  S direction{};                       ///< of the sliding, -1 or 1; 0: it sticks; out
};

/// Where tau_e comes from, and so how a sliding joint is braked: by F in the first pass, by a damper in all others.
enum class Loads { of_last_pass, of_repeated_pass, of_last_step };

/// Leaves to base, like sweep_to_base. The bodies' `acceleration` is that of the last pass; `torque` and `added_inertia` are not used. `dt` [s] > 0.
template <class S>
void sweep_with_friction(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies,
                         std::span<FrictionalJoint<S>> joints, Loads loads, double dt) noexcept;

/// Base to leaves, like `accelerate`. Returns how many joints should have been decided otherwise, lane by lane; where it
/// is not 0, the pass has to be repeated.
template <class S>
[[nodiscard]] S accelerate_with_friction(const Tree& tree, std::span<const LinkMotion<S>> links,
                                         std::span<ArticulatedLink<S>> bodies, std::span<FrictionalJoint<S>> joints,
                                         const Twist<S>& base) noexcept;

/// The same count for what the joints feel now (`load`), if that has changed since.
template <class S>
[[nodiscard]] S wrong_decisions(std::span<const FrictionalJoint<S>> joints) noexcept;

/// Whether each motor follows the line that it should for what the joints feel now (`load`), after a step of `dt` [s].
[[nodiscard]] bool follow_their_lines(std::span<const FrictionalJoint<double>> joints, double dt) noexcept;

/// The motor is at none of its bounds in this step; in lanes: where.
template <class S>
[[nodiscard]] auto is_free(const FrictionalJoint<S>& joint) noexcept {
  return joint.line == joint.motor.free;
}

/// What friction does [N m | N] at the end of the step, for what the joint feels in the end (`load`).
template <class S>
[[nodiscard]] S friction_torque(const FrictionalJoint<S>& joint) noexcept {
  const S all = -(joint.drive + joint.load);
  return select(joint.direction == S(0.0), all, -(joint.direction * joint.budget));
}

}  // namespace murosimf::multibody
