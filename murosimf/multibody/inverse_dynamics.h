/// inverse_dynamics.h - the forces that produce a motion (recursive Newton-Euler), and the joint-space inertia matrix.
///
/// All quantities refer to one point (link_motion.h):
///
///     a'_i = a'_p + s_i qdd_i       f_i = I_i a'_i + p_i - f_ext,i + sum of the children's f
///     tau_i = s_i . f_i             base force = f_0
///
/// Gravity g enters as the base acceleration a'_0 = a_0 - [0; g] (Featherstone 2008, sec. 5.3).
///
/// The joint-space inertia matrix (composite-rigid-body algorithm, ibid. sec. 6.2) is the same tree of sums:
///
///     F_i = Ic_i s_i        M_ii = s_i . F_i        M_ij = s_j . F_i for joints j towards the base
///
/// Its first six rows [Ic_0  F_1 ... F_n] are the paper's eq. (3): base force = Ic_0 a'_0 + sum F_i qdd_i + sum p_i.
#pragma once

#include <span>

#include "murosimf/multibody/link_motion.h"

namespace murosimf::multibody {

/// `base` [rad/s^2; m/s^2] a'_0; qdd [rad/s^2 | m/s^2], `external` [N m, N] about O and the results by link: `force` [N
/// m, N] f_i, which also serves as working memory, and `torque` [N m | N], 0 for the base. Rotors are not included.
template <class S>
void inverse_dynamics(const Tree& tree, std::span<const LinkMotion<S>> links, const Twist<S>& base,
                      std::span<const S> qdd, std::span<const Wrench<S>> external, std::span<Wrench<S>> force,
                      std::span<S> torque) noexcept;

/// Force [N m, N] about O that the joint accelerations qdd require of a base with a'_0 = 0, external forces left out:
/// sum of I_i J_i qdd + p_i over all links.
template <class S>
[[nodiscard]] Wrench<S> base_bias(const Tree& tree, std::span<const LinkMotion<S>> links, std::span<const S> qdd,
                                  std::span<Twist<S>> working) noexcept;

/// M, row by row, 6 + (links - 1) square: base [w; v] about O first, then one row per link in order.
/// `composite`: working memory, one per link. Rotors are not included.
void mass_matrix(const Tree& tree, std::span<const LinkMotion<double>> links, std::span<RigidInertia<double>> composite,
                 std::span<double> M) noexcept;

}  // namespace murosimf::multibody
