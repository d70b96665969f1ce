/// sanity.h - when the numbers of an entity have gone bad. Written so that NaN is not sane either.
#pragma once

#include <cmath>

#include "murosimf/multibody/integrate.h"

namespace murosimf::motion {

inline constexpr double farthest = 1e6;      // [m]
inline constexpr double fastest = 1e3;       // [m/s]
inline constexpr double fastest_turn = 1e4;  // [rad/s]

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

/// A force on a body, or what makes it fall with velocity, is exactly zero for bodies that nothing touches: by far the
/// most.
[[nodiscard]] inline bool is_zero(const Forced& force) { return is_zero(force.n) && is_zero(force.f); }
/// A positive semidefinite matrix without diagonal is zero.
[[nodiscard]] inline bool is_zero(const Sym6d& m) {
  return m.J.xx == 0 && m.J.yy == 0 && m.J.zz == 0 && m.M.xx == 0 && m.M.yy == 0 && m.M.zz == 0;
}

}  // namespace murosimf::motion
