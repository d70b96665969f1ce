/// articulated_body.h - forward dynamics of a tree with a free base: the articulated-body algorithm.
///
/// Everything about one point (link_motion.h), so the sweeps carry nothing from frame to frame. From leaves to base:
///
///     U_i = IA_i s_i        D_i = s_i . U_i + A_i        u_i = tau_i - s_i . pA_i
///     IA_p += IA_i - U_i U_i^T / D_i                     pA_p += pA_i + U_i u_i / D_i
///
/// and back, with a'_0 from the base (free: -IA_0^-1 pA_0):
///
///     qdd_i = (u_i - U_i . a'_p) / D_i                   a'_i = a'_p + s_i qdd_i
///
/// a' counts from the accelerations that velocities and gravity make by themselves (b_i + [0; g]); what remains is
/// linear, and no velocity product appears in the sweeps.
/// Extension points: A_i is any inertia that belongs to the joint alone (rotor, h b + h^2 k of an implicit spring and
/// damper); a body's force f - h B a_x, linear in its acceleration, is added to IA_i and pA_i before the sweep.
/// Source: Featherstone 2008, sec. 7.3; rotor inertia ibid. sec. 9.6.
#pragma once

#include <span>

#include "murosimf/multibody/link_motion.h"

namespace murosimf::multibody {

template <class S>
struct ArticulatedLink {
  Sym6<S> inertia;         ///< what loads and children add to the link's own inertia; the base's whole IA_0 in the end
  Wrench<S> force;         ///< [N m; N] the same for pA
  bool loaded = false;     ///< `inertia` and `force` hold something
  S torque{};              ///< tau [N m | N]; in
  S added_inertia{};       ///< A [kg m^2 | kg]; in
  Wrench<S> U;             ///< out
  S inverse_D{};           ///< 1/D; out
  S u{};                   ///< [N m | N] out
  Twist<S> acceleration;   ///< a'; out of `accelerate`
  S joint_acceleration{};  ///< qdd [rad/s^2 | m/s^2]; out of `accelerate`
};

/// No loads on any link.
template <class S>
void clear_loads(std::span<ArticulatedLink<S>> bodies) noexcept;

/// A force [N m, N] about O on a link, and what it loses with the link's acceleration: force - damping a'.
template <class S>
void add_load(ArticulatedLink<S>& body, const Wrench<S>& force, const Sym6<S>& damping) noexcept;

/// Leaves to base.
template <class S>
void sweep_to_base(const Tree& tree, std::span<const LinkMotion<S>> links,
                   std::span<ArticulatedLink<S>> bodies) noexcept;

/// Base to leaves; `base` is a'_0 [rad/s^2; m/s^2].
template <class S>
void accelerate(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<ArticulatedLink<S>> bodies,
                const Twist<S>& base) noexcept;

}  // namespace murosimf::multibody
