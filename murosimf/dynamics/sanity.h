/// sanity.h - criteria of sane numbers. Written so that NaN is not sane either.
#pragma once

#include <cmath>
#include <span>

#include "murosimf/multibody/articulated_body.h"
#include "murosimf/multibody/integrate.h"

namespace murosimf::dynamics {

inline constexpr double farthest = 1e6;         // [m]
inline constexpr double fastest = 1e3;          // [m/s]
inline constexpr double fastest_turn = 1e4;     // [rad/s]
inline constexpr double fastest_joint = 1e4;    // [rad/s | m/s]
inline constexpr double least_inertia = 1e-12;  // [kg m^2 | kg] that a joint must move
inline constexpr double farthest_joint = 1e4;   // [rad | m] beyond it sines lose their precision

/// Reason for freezing an entity whose state is not sane.
inline constexpr const char* too_fast =
    "it went beyond 1000 m/s, 10000 rad/s or 1000 km, or its numbers are none (a force, a target or a step too large)";

[[nodiscard]] inline bool is_sane(const multibody::FreeBody<double>& body) {
  const Quaterniond& q = body.turn;
  return dot(body.velocity, body.velocity) < fastest * fastest &&
         dot(body.rate, body.rate) < fastest_turn * fastest_turn &&
         dot(body.position, body.position) < farthest * farthest &&
         std::abs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1) < 1e-6;
}

inline constexpr const char* joints_insane = "a joint position or target is no sensible number";

/// Whether the change of the velocities in a step of dt [s] is sane.
[[nodiscard]] inline bool is_sane(const Twistd& acceleration, double dt) {
  return dt * norm(acceleration.v) < fastest && dt * norm(acceleration.w) < fastest_turn;
}

/// Whether all accelerations are numbers. How large those of joints without inertia of their own are before couplings hold them says nothing.
[[nodiscard]] inline bool are_numbers(std::span<const multibody::ArticulatedLink<double>> bodies) {
  double sum = norm(bodies[0].acceleration.v) + norm(bodies[0].acceleration.w);
  for (const auto& body : bodies) sum += body.joint_acceleration;
  return std::isfinite(sum);
}

}  // namespace murosimf::dynamics
