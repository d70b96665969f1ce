/// kinematics.h - direct kinematics: poses and velocities of all objects of a tree.
///
/// Recursion from the base outwards (Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 4; here in world axes):
///
///     r_i = r_p + R_p d_i (+ R_i s q)      R_i = R_p T_i rot(s, q)
///     w_i = w_p (+ R_i s qd)               v_i = v_p + w_p x (r_i - r_p) (+ R_i s qd)
///
/// with d, T the place of joint i in its parent link, s the joint axis; the terms in brackets by kind of joint.
/// Rows of structural objects (model/object.h) are not computed. All spans have one row per object. Row 0 of r, R, v, w (the
/// base) is input; the other rows are output.
#pragma once

#include <span>

#include "murosimf/math/spatial.h"
#include "murosimf/math/transform.h"
#include "murosimf/model/tree.h"

namespace murosimf::multibody {

/// q [rad | m] joint positions; r [m], R: origin and axes of each object, world frame.
template <class S>
void poses(const Tree& tree, std::span<const S> q, std::span<Vec3<S>> r, std::span<Mat3<S>> R) noexcept;

/// qd [rad/s | m/s] joint rates; v [m/s] of each object's origin and w [rad/s], world frame. r, R as from `poses`.
template <class S>
void velocities(const Tree& tree, std::span<const S> qd, std::span<const Vec3<S>> r, std::span<const Mat3<S>> R,
                std::span<Vec3<S>> v, std::span<Vec3<S>> w) noexcept;

/// Pose of one fixed object in the frame of the base, from the joint positions on the path to it alone.
/// `path`: links from the base (excluded) to the object's link.
template <class S>
[[nodiscard]] Transform<S> pose_in_base(const Tree& tree, std::span<const int> path, const FixedObject& object,
                                        std::span<const S> q) noexcept;

/// Velocity [rad/s, m/s] of the point `at` [m] of the path's last link, relative to a base at rest; world axes:
///     w = sum s_i qd_i     v = sum s_i x (at - r_i) qd_i   (or s_i qd_i)
template <class S>
[[nodiscard]] Twist<S> twist_against_base(const Tree& tree, std::span<const int> path, const Vec3<S>& at,
                                          std::span<const S> qd, std::span<const Vec3<S>> r,
                                          std::span<const Mat3<S>> R) noexcept;

/// Adds `shift` to every row: translates positions or velocities of a whole robot.
template <class S>
void shift_all(std::span<Vec3<S>> rows, const Vec3<S>& shift) noexcept;

}  // namespace murosimf::multibody
