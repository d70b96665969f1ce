/// mass.h - the whole robot as one body: total mass, common center of mass, its velocity, common inertia.
///
///     m = sum m_i     c = sum m_i c_i / m     vc = sum m_i (v_i + w_i x (c_i - r_i)) / m
///     I = sum (R_i I_i R_i^T + m_i (|d_i|^2 1 - d_i d_i^T)),   d_i = c_i - c        (parallel-axis theorem)
///
/// Source: textbook mechanics; the tree must have mass.
#pragma once

#include <span>

#include "murosimf/math/mat3.h"
#include "murosimf/model/tree.h"

namespace murosimf::multibody {

template <class S>
struct CommonBody {
  double mass = 0;     ///< [kg]
  Vec3<S> center;      ///< [m] common center of mass, frame of r
  Vec3<S> velocity;    ///< [m/s] of the common center of mass, same axes
  SymMat3<S> inertia;  ///< [kg m^2] at the common center of mass, same axes
};

/// r [m], R, v [m/s], w [rad/s]: one row per object, in any common frame.
template <class S>
[[nodiscard]] CommonBody<S> common_body(const Tree& tree, std::span<const Vec3<S>> r, std::span<const Mat3<S>> R,
                                        std::span<const Vec3<S>> v, std::span<const Vec3<S>> w) noexcept;

}  // namespace murosimf::multibody
