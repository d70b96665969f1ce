/// sanity.h - when the numbers of an entity have gone bad. Written so that NaN is not sane either.
#pragma once

#include <cmath>

#include "murosimf/multibody/integrate.h"

namespace murosimf::motion {

inline constexpr double farthest = 1e6;      // [m]
inline constexpr double fastest = 1e3;       // [m/s]
inline constexpr double fastest_turn = 1e4;  // [rad/s]

/// Why an entity is frozen whose state is not sane.
inline constexpr const char* too_fast =
    "it went beyond 1000 m/s, 10000 rad/s or 1000 km, or its numbers are none (a force, a target or a step too large)";

[[nodiscard]] inline bool is_sane(const multibody::FreeBody<double>& body) {
  const Quaterniond& q = body.turn;
  return dot(body.velocity, body.velocity) < fastest * fastest &&
         dot(body.rate, body.rate) < fastest_turn * fastest_turn &&
         dot(body.position, body.position) < farthest * farthest &&
         std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < 1e-6;
}

/// What a step of dt [s] adds to the velocities, written so that NaN is not sane either.
[[nodiscard]] inline bool is_sane(const Motiond& acceleration, double dt) {
  return dt * norm(acceleration.v) < fastest && dt * norm(acceleration.w) < fastest_turn;
}

/// Positive definite, and not only by rounding: no direction has less than 1e-12 of the mean inertia.
[[nodiscard]] inline bool is_firmly_positive(const Sym6d& A) {
  const auto firm = [](const SymMat3d& m) {
    const double mean = (m.xx + m.yy + m.zz) / 3;
    return is_positive_definite(m) && is_positive_definite(m - diagonal(1e-12 * mean));
  };
  if (!firm(A.M)) return false;
  const SymMat3d inverse_M = inverse(A.M);
  const Mat3d H_T = transpose(A.H);
  const Mat3d X{inverse_M * H_T.x, inverse_M * H_T.y, inverse_M * H_T.z};
  return firm(A.J - SymMat3d{dot(X.x, H_T.x), dot(X.y, H_T.y), dot(X.z, H_T.z), dot(X.x, H_T.y), dot(X.x, H_T.z),
                             dot(X.y, H_T.z)});
}

/// A force on a body, or what makes it fall with velocity, is exactly zero for bodies that nothing touches: by far the
/// most.
[[nodiscard]] inline bool is_zero(const Forced& force) { return is_zero(force.n) && is_zero(force.f); }
/// A positive semidefinite matrix without diagonal is zero.
[[nodiscard]] inline bool is_zero(const Sym6d& m) {
  return m.J.xx == 0 && m.J.yy == 0 && m.J.zz == 0 && m.M.xx == 0 && m.M.yy == 0 && m.M.zz == 0;
}

}  // namespace murosimf::motion
