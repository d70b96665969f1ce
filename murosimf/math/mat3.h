/// mat3.h - 3x3 matrices: rotations, and symmetric ones kept as a triangle.
///
/// A rotation R_AB takes vectors from frame B to frame A; its columns are the axes of B seen in A, and
/// R_AB * R_BC = R_AC cancels visibly. Storage is by columns, so the axes can be used as vectors.
#pragma once

#include "murosimf/math/vec3.h"

namespace murosimf {

template <class S>
struct Mat3 {
  Vec3<S> x{S(1.0), S(0.0), S(0.0)}, y{S(0.0), S(1.0), S(0.0)}, z{S(0.0), S(0.0), S(1.0)};  ///< columns
};

using Mat3d = Mat3<double>;

template <class A, class B>
MUROSIMF_INLINE auto operator*(const Mat3<A>& m, const Vec3<B>& v) -> Vec3<Product<A, B>> {
  return {m.x.x * v.x + m.y.x * v.y + m.z.x * v.z, m.x.y * v.x + m.y.y * v.y + m.z.y * v.z,
          m.x.z * v.x + m.y.z * v.y + m.z.z * v.z};
}
template <class A, class B>
MUROSIMF_INLINE auto operator*(const Mat3<A>& m, const Mat3<B>& n) -> Mat3<Product<A, B>> {
  return {m * n.x, m * n.y, m * n.z};
}
template <class S>
MUROSIMF_INLINE Mat3<S> transpose(const Mat3<S>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
/// m^T v: takes a vector of the outer frame into the inner one.
template <class A, class B>
MUROSIMF_INLINE auto transposed_times(const Mat3<A>& m, const Vec3<B>& v) -> Vec3<Product<A, B>> {
  return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

/// Rotation about the unit vector `axis` by the angle with the given sine and cosine (Rodrigues).
template <class A, class S>
Mat3<S> rotation(const Vec3<A>& axis, const SinCos<S>& angle) {
  const auto [s, c] = angle;
  const S t = 1.0 - c;
  const auto& [x, y, z] = axis;
  return {{c + t * (x * x), t * (x * y) + s * z, t * (x * z) - s * y},
          {t * (x * y) - s * z, c + t * (y * y), t * (y * z) + s * x},
          {t * (x * z) + s * y, t * (y * z) - s * x, c + t * (z * z)}};
}
template <class A, class S>
Mat3<S> rotation(const Vec3<A>& axis, S angle) {
  return rotation(axis, sin_cos(angle));
}
inline Mat3d rotation_x(double angle) { return rotation(Vec3d{1, 0, 0}, angle); }
inline Mat3d rotation_y(double angle) { return rotation(Vec3d{0, 1, 0}, angle); }
inline Mat3d rotation_z(double angle) { return rotation(Vec3d{0, 0, 1}, angle); }

/// Exactly no turn.
inline bool is_identity(const Mat3d& m) {
  return is_zero(m.x - Vec3d{1, 0, 0}) && is_zero(m.y - Vec3d{0, 1, 0}) && is_zero(m.z - Vec3d{0, 0, 1});
}

/// Turn of the local x axis about the vertical [rad]: the heading of a frame that stands about upright.
inline double heading(const Mat3d& m) { return std::atan2(m.x.y, m.x.x); }

/// Symmetric 3x3 matrix: its upper triangle.
template <class S>
struct SymMat3 {
  S xx{}, yy{}, zz{}, xy{}, xz{}, yz{};
};

using SymMat3d = SymMat3<double>;

template <class A, class B>
MUROSIMF_INLINE auto operator*(const SymMat3<A>& m, const Vec3<B>& v) -> Vec3<Product<A, B>> {
  return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
          m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
template <class S>
MUROSIMF_INLINE SymMat3<S> operator+(const SymMat3<S>& a, const SymMat3<S>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
template <class S>
MUROSIMF_INLINE SymMat3<S> operator-(const SymMat3<S>& a, const SymMat3<S>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
}
template <class A, class S>
MUROSIMF_INLINE SymMat3<S> operator*(const A& s, const SymMat3<S>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz};
}
template <class S>
MUROSIMF_INLINE SymMat3<S>& operator+=(SymMat3<S>& a, const SymMat3<S>& b) {
  // by members: a whole temporary would go through memory
  a.xx = a.xx + b.xx;
  a.yy = a.yy + b.yy;
  a.zz = a.zz + b.zz;
  a.xy = a.xy + b.xy;
  a.xz = a.xz + b.xz;
  a.yz = a.yz + b.yz;
  return a;
}

/// s times the identity.
template <class S>
MUROSIMF_INLINE SymMat3<S> diagonal(S s) {
  return {s, s, s, S{}, S{}, S{}};
}
/// v v^T.
template <class S>
MUROSIMF_INLINE SymMat3<S> outer(const Vec3<S>& v) {
  return {v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.x * v.z, v.y * v.z};
}
/// -v^ v^ = |v|^2 1 - v v^T: the inertia of a unit mass at v (parallel-axis term).
template <class S>
MUROSIMF_INLINE SymMat3<S> inertia_of_point(const Vec3<S>& v) {
  const S xx = v.x * v.x, yy = v.y * v.y, zz = v.z * v.z;
  return {yy + zz, xx + zz, xx + yy, -(v.x * v.y), -(v.x * v.z), -(v.y * v.z)};
}
/// Inverse of a symmetric matrix, by its adjugate; the determinant must not be zero.
template <class S>
SymMat3<S> inverse(const SymMat3<S>& m) {
  const S xx = m.yy * m.zz - m.yz * m.yz, xy = m.xz * m.yz - m.xy * m.zz, xz = m.xy * m.yz - m.xz * m.yy;
  const S scale = 1.0 / (m.xx * xx + m.xy * xy + m.xz * xz);
  return {scale * xx, scale * (m.xx * m.zz - m.xz * m.xz), scale * (m.xx * m.yy - m.xy * m.xy), scale * xy,
          scale * xz, scale * (m.xy * m.xz - m.xx * m.yz)};
}
/// Leading minors are positive (Sylvester's criterion) and finite; false for NaN.
inline bool is_positive_definite(const SymMat3d& m) {
  const double minor = m.xx * m.yy - m.xy * m.xy;
  const double determinant =
      m.xx * (m.yy * m.zz - m.yz * m.yz) - m.xy * (m.xy * m.zz - m.yz * m.xz) + m.xz * (m.xy * m.yz - m.yy * m.xz);
  return m.xx > 0 && minor > 0 && determinant > 0 && std::isfinite(determinant);
}

/// R m R^T: the symmetric tensor `m` of the inner frame seen in the outer one.
template <class S, class A>
MUROSIMF_INLINE SymMat3<S> rotated(const Mat3<S>& R, const SymMat3<A>& m) {
  const Vec3<S> a = m.xx * R.x + m.xy * R.y + m.xz * R.z;  // columns of R m
  const Vec3<S> b = m.xy * R.x + m.yy * R.y + m.yz * R.z;
  const Vec3<S> c = m.xz * R.x + m.yz * R.y + m.zz * R.z;
  return {a.x * R.x.x + b.x * R.y.x + c.x * R.z.x, a.y * R.x.y + b.y * R.y.y + c.y * R.z.y,
          a.z * R.x.z + b.z * R.y.z + c.z * R.z.z, a.x * R.x.y + b.x * R.y.y + c.x * R.z.y,
          a.x * R.x.z + b.x * R.y.z + c.x * R.z.z, a.y * R.x.z + b.y * R.y.z + c.y * R.z.z};
}

}  // namespace murosimf
