/// vec3.h - vectors of three components.
#pragma once

#include "murosimf/math/scalar.h"

namespace murosimf {

template <class S>
struct Vec3 {
  S x{}, y{}, z{};
};

using Vec3d = Vec3<double>;

template <class A, class B>
MUROSIMF_INLINE auto operator+(const Vec3<A>& a, const Vec3<B>& b) -> Vec3<Product<A, B>> {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
MUROSIMF_INLINE auto operator-(const Vec3<A>& a, const Vec3<B>& b) -> Vec3<Product<A, B>> {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S>
MUROSIMF_INLINE Vec3<S> operator-(const Vec3<S>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class A, class B>
MUROSIMF_INLINE auto operator*(const A& s, const Vec3<B>& a) -> Vec3<Product<A, B>> {
  return {s * a.x, s * a.y, s * a.z};
}
template <class A, class B>
MUROSIMF_INLINE Vec3<A>& operator+=(Vec3<A>& a, const Vec3<B>& b) {
  a.x = a.x + b.x;
  a.y = a.y + b.y;
  a.z = a.z + b.z;
  return a;
}
template <class A, class B>
MUROSIMF_INLINE Vec3<A>& operator-=(Vec3<A>& a, const Vec3<B>& b) {
  a.x = a.x - b.x;
  a.y = a.y - b.y;
  a.z = a.z - b.z;
  return a;
}

template <class A, class B>
MUROSIMF_INLINE auto dot(const Vec3<A>& a, const Vec3<B>& b) -> Product<A, B> {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
MUROSIMF_INLINE auto cross(const Vec3<A>& a, const Vec3<B>& b) -> Vec3<Product<A, B>> {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class S>
MUROSIMF_INLINE S norm(const Vec3<S>& a) {
  return sqrt(dot(a, a));
}

/// True if all components are exactly zero.
inline bool is_zero(const Vec3d& a) { return are_zero(a.x, a.y, a.z); }

/// `a` without its component along the unit vector `n`.
template <class A, class B>
MUROSIMF_INLINE auto tangential(const Vec3<A>& a, const Vec3<B>& n) -> Vec3<Product<A, B>> {
  return a - dot(a, n) * n;
}

}  // namespace murosimf
