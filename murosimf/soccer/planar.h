/// planar.h - poses on the ground: x [m], y [m] and heading [rad], counterclockwise, as the three numbers of a vector.
#pragma once

#include <cmath>

#include "murosimf/math/vec3.h"

namespace murosimf::soccer {

/// [rad] The same direction, from -pi to pi.
[[nodiscard]] inline double wrapped(double angle) noexcept { return std::remainder(angle, 2 * pi); }

/// [m] A point (x, y) of the frame `pose`, in the frame in which the pose is given. z stays.
[[nodiscard]] inline Vec3d from_frame(const Vec3d& pose, const Vec3d& point) noexcept {
  const double c = std::cos(pose.z), s = std::sin(pose.z);
  return {pose.x + c * point.x - s * point.y, pose.y + s * point.x + c * point.y, point.z};
}

/// [m] The inverse: a point, seen in the frame `pose`.
[[nodiscard]] inline Vec3d to_frame(const Vec3d& pose, const Vec3d& point) noexcept {
  const double c = std::cos(pose.z), s = std::sin(pose.z), x = point.x - pose.x, y = point.y - pose.y;
  return {c * x + s * y, -s * x + c * y, point.z};
}

/// The pose after a `step` that is given in the frame of `pose`.
[[nodiscard]] inline Vec3d moved(const Vec3d& pose, const Vec3d& step) noexcept {
  const Vec3d place = from_frame(pose, step);
  return {place.x, place.y, wrapped(pose.z + step.z)};
}

}  // namespace murosimf::soccer
