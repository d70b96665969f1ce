/// articulated_body.h - forward dynamics of a tree with a free base: the articulated-body algorithm.
///
/// All vectors and matrices refer to one point (link_motion.h), so the sweeps transform nothing between frames. From leaves to base:
///
///     U_i = IA_i s_i        D_i = s_i . U_i + A_i        u_i = tau_i - s_i . pA_i
///     IA_p += IA_i - U_i U_i^T / D_i                     pA_p += pA_i + U_i u_i / D_i
///
/// and back, with a'_0 from the base (free: -IA_0^-1 pA_0):
///
///     qdd_i = (u_i - U_i . a'_p) / D_i                   a'_i = a'_p + s_i qdd_i
///
/// a' is measured relative to the accelerations due to velocities and gravity alone (b_i + [0; g]); the remainder is
/// linear in the forces, and no velocity product appears in the sweeps.
/// Extension points: A_i is any inertia that acts on the joint alone (rotor, h b + h^2 k of an implicit spring and
/// damper); a body's force f - h B a_x, linear in its acceleration, is added to IA_i and pA_i before the sweep.
/// Source: Featherstone 2008, sec. 7.3; rotor inertia ibid. sec. 9.6.
#pragma once

#include <span>

#include "murosimf/multibody/link_motion.h"

namespace murosimf::multibody {

template <class S>
struct ArticulatedLink {
  Sym6<S>
      inertia;  ///< contribution of loads and children to the link's own inertia; of the base: the whole IA_0 after the sweep
  Wrench<S> force;         ///< [N m; N] the same contribution to pA
  bool loaded = false;     ///< whether `inertia` and `force` are valid
  S torque{};              ///< tau [N m | N]; in
  S added_inertia{};       ///< A [kg m^2 | kg]; in
  Wrench<S> U;             ///< out
  S inverse_D{};           ///< 1/D; out
  S u{};                   ///< [N m | N] out
  Twist<S> acceleration;   ///< a'; out of `accelerate`
  S joint_acceleration{};  ///< qdd [rad/s^2 | m/s^2]; out of `accelerate`
};

/// Removes the loads of all links.
template <class S>
void clear_loads(std::span<ArticulatedLink<S>> bodies) noexcept;

/// Adds a force [N m, N] about O to a link, and its decrease with the link's acceleration: force - damping a'.
template <class S>
void add_load(ArticulatedLink<S>& body, const Wrench<S>& force, const Sym6<S>& damping) noexcept;

/// Sweeps from leaves to base: articulated inertias and forces, U, 1/D and u of all links.
template <class S>
void sweep_to_base(const Tree& tree, std::span<const LinkMotion<S>> links,
                   std::span<ArticulatedLink<S>> bodies) noexcept;

/// Sweeps from base to leaves: accelerations of all links and joints; `base` is a'_0 [rad/s^2; m/s^2].
template <class S>
void accelerate(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies,
                const Twist<S>& base) noexcept;

}  // namespace murosimf::multibody
