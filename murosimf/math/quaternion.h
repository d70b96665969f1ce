/// quaternion.h - unit quaternions, stored w, x, y, z; they take body axes to world axes.
#pragma once

#include "murosimf/math/mat3.h"

namespace murosimf {

template <class S>
struct Quaternion {
  S w{1.0}, x{}, y{}, z{};
};

using Quaterniond = Quaternion<double>;

template <class S>
Quaternion<S> operator*(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

template <class S>
Quaternion<S> normalized(const Quaternion<S>& q) {
  const S scale = 1.0 / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

template <class S>
Mat3<S> to_matrix(const Quaternion<S>& q) {
  const S xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const S xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const S wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{1.0 - 2.0 * (yy + zz), 2.0 * (xy + wz), 2.0 * (xz - wy)},
          {2.0 * (xy - wz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz + wx)},
          {2.0 * (xz + wy), 2.0 * (yz - wx), 1.0 - 2.0 * (xx + yy)}};
}

/// Exponential map: the rotation by |phi| [rad] about phi.
template <class S>
Quaternion<S> exponential(const Vec3<S>& phi) {
  const S half_squared = 0.25 * dot(phi, phi);
  const auto small = half_squared < S(1e-8);
  const S half = sqrt(half_squared);
  const auto [s, c] = sin_cos(half);
  // below |phi| = 2e-4 the series of sin(h)/h has an error under 1e-18
  const S sinc = select(small, 1.0 - half_squared * (1.0 / 6.0), s / select(small, S(1.0), half));
  return {c, 0.5 * sinc * phi.x, 0.5 * sinc * phi.y, 0.5 * sinc * phi.z};
}

/// Unit quaternion of a rotation matrix (Shepperd's choice of the largest component; w >= 0).
Quaterniond from_matrix(const Mat3d& m);

/// Rotation vector [rad] of a unit quaternion, |result| <= pi: the inverse of `exponential`.
Vec3d rotation_vector(const Quaterniond& q);

}  // namespace murosimf
