/// link_motion.h - the motion and inertia of every link, as all algorithms of rigid-body dynamics use them.
///
/// All vectors are in world axes, and all moments and linear velocities are taken at one point: the origin O of the
/// base at this instant, in the inertial frame that moves with the present constant velocity of the base's origin (the
/// equations of motion are the same in it, and the base's own linear velocity is zero). So nothing has to be transformed
/// between links: sums over links are plain sums. With s the joint axis and d = r - r_0:
///
///     s_i = [a_i; d_i x a_i] (revolute)   [0; a_i] (prismatic)
///     v_i = v_p + s_i qd_i                b_i = b_p + v_p x s_i qd_i
///     p_i = I_i b_i + v_i x* I_i v_i
///
/// b is the acceleration of a link while the base and all joints have none, p the force that b requires. True
/// accelerations are linear on top of that: a_i = b_i + J_i [a_0; qdd].
/// Source: Featherstone, Rigid Body Dynamics Algorithms, 2008, sec. 5.3 (recursive Newton-Euler algorithm), 2.10
/// (accelerations); the common reference point as in ch. 5, "global" form.
#pragma once

#include <span>

#include "murosimf/math/rigid_inertia.h"
#include "murosimf/model/tree.h"

namespace murosimf::multibody {

template <class S>
struct LinkMotion {
  Twist<S> axis;            ///< s: [1; m] or [0; 1]; zero for the base
  Twist<S> velocity;        ///< v: [rad/s; m/s], of the base: [w; 0]
  Twist<S> bias;            ///< b: [rad/s^2; m/s^2]
  RigidInertia<S> inertia;  ///< I
  Wrench<S> bias_force;     ///< p: [N m; N]; without gravity
};

/// Fills one row per link of the tree. r [m], R: poses of the objects, world; w [rad/s] of the base, world; qd [rad/s |
/// m/s] by object.
template <class S>
void link_motions(const Tree& tree, std::span<const Vec3<S>> r, std::span<const Mat3<S>> R, const Vec3<S>& w,
                  std::span<const S> qd, std::span<LinkMotion<S>> links) noexcept;

/// Sum of the links' inertias: the robot as one body, about O.
template <class S>
[[nodiscard]] RigidInertia<S> composite_inertia(std::span<const LinkMotion<S>> links) noexcept;

/// Inertia that each joint moves while all other joints are fixed [kg m^2 | kg], by link; without rotors.
void moved_inertias(const Tree& tree, std::span<const LinkMotion<double>> links, std::span<double> moved);

/// Momentum of all links: moment of momentum about O [N m s] and momentum [N s], in the frame that moves with the base's
/// origin.
template <class S>
[[nodiscard]] Wrench<S> momentum(std::span<const LinkMotion<S>> links) noexcept;

/// Its linear part alone [N s].
template <class S>
[[nodiscard]] Vec3<S> linear_momentum(std::span<const LinkMotion<S>> links) noexcept;

/// Kinetic energy [J] for a base whose origin moves with v0 [m/s], without rotors.
template <class S>
[[nodiscard]] S kinetic_energy(std::span<const LinkMotion<S>> links, const Vec3<S>& v0) noexcept;

/// Potential energy [J] in the field `gravity` [m/s^2], zero at the world's origin; r0 [m] origin of the base.
template <class S>
[[nodiscard]] S potential_energy(std::span<const LinkMotion<S>> links, const Vec3<S>& r0,
                                 const Vec3d& gravity) noexcept;

}  // namespace murosimf::multibody
