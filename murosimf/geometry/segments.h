/// segments.h - straight lines of finite length.
#pragma once

#include <algorithm>

#include "murosimf/math/vec3.h"

namespace murosimf::geometry {

struct Segment {
  Vec3d middle;  ///< [m]
  Vec3d half;    ///< [m] from the middle to one end

  /// s from -1 to 1.
  [[nodiscard]] Vec3d at(double s) const { return middle + s * half; }
};

/// Where two segments are closest: the places along them, from -1 to 1.
struct ClosestPlaces {
  double s = 0, t = 0;
};

/// Source: Ericson, Real-Time Collision Detection, 2005, sec. 5.1.9.
[[nodiscard]] inline ClosestPlaces closest_places(const Segment& a, const Segment& b) {
  const Vec3d w = a.middle - b.middle;
  const double uu = dot(a.half, a.half), vv = dot(b.half, b.half), uv = dot(a.half, b.half);
  const double uw = dot(a.half, w), vw = dot(b.half, w);
  const double parallel = uu * vv - uv * uv;
  const auto limit = [](double x) { return std::clamp(x, -1.0, 1.0); };
  double s = parallel > 1e-12 * uu * vv ? limit((uv * vw - vv * uw) / parallel) : 0;
  const double t = vv > 0 ? limit((uv * s + vw) / vv) : 0;
  s = uu > 0 ? limit((uv * t - uw) / uu) : 0;
  return {s, t};
}

}  // namespace murosimf::geometry
