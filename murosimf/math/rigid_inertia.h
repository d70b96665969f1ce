/// rigid_inertia.h - inertia of a rigid body as ten numbers.
///
/// About a reference point O, with center of mass c from O and inertia Ic at the center of mass (Featherstone 2008,
/// eq. 2.63):
///
///     n = J w + h x v        J = Ic + m (|c|^2 1 - c c^T)
///     f = m v - h x w        h = m c
#pragma once

#include "murosimf/math/spatial.h"

namespace murosimf {

template <class S>
struct RigidInertia {
  double mass = 0;    ///< [kg] of the model, therefore the same in all lanes
  Vec3<S> first;      ///< [kg m] h: mass times center of mass, from the reference point
  SymMat3<S> second;  ///< [kg m^2] J: inertia at the reference point
};

template <class S>
MUROSIMF_INLINE RigidInertia<S>& operator+=(RigidInertia<S>& a, const RigidInertia<S>& b) {
  a.mass += b.mass;
  a.first += b.first;
  a.second += b.second;
  return a;
}

template <class S>
MUROSIMF_INLINE Wrench<S> operator*(const RigidInertia<S>& a, const Twist<S>& m) {
  return {a.second * m.w + cross(a.first, m.v), a.mass * m.v - cross(a.first, m.w)};
}

/// The same map as a general symmetric matrix.
template <class S>
MUROSIMF_INLINE Sym6<S> to_sym6(const RigidInertia<S>& a) {
  return {a.second, cross_matrix(a.first), diagonal(S(a.mass))};
}

}  // namespace murosimf
