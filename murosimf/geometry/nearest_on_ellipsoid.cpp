#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/geometry/nearest.h"

// The nearest point x of x_i^2 / e_i^2 = 1 to y has y - x along its normal: x_i = e_i^2 y_i / (t + e_i^2), where t is the
// largest root of F(t) = sum (e_i y_i / (t + e_i^2))^2 - 1. Source: D. Eberly, Distance from a Point to an Ellipse, an
// Ellipsoid, or a Hyperellipsoid, 2013. With s = t + e_min^2 nothing cancels near the pole at s = 0; F falls and is
// convex for s > 0, so Newton's method from where F >= 0 rises to the root and never passes it.
namespace murosimf::geometry {
namespace {

struct Octant {
  std::array<double, 3> e, y, gap;  // semi-axes, point (none negative), e_i^2 - e_min^2

  /// Where F is not negative.
  [[nodiscard]] double start() const {
    double s = 0;
    for (int i = 0; i < 3; ++i) s = std::max(s, e[i] * y[i] - gap[i]);
    return s;
  }
  [[nodiscard]] double root() const {
    double s = start();
    for (int iteration = 0; iteration < 200; ++iteration) {
      double f = -1, slope = 0;
      for (int i = 0; i < 3; ++i) {
        if (y[i] == 0) continue;
        const double ratio = e[i] * y[i] / (s + gap[i]);
        f += ratio * ratio;
        slope -= 2 * ratio * ratio / (s + gap[i]);
      }
      if (!(f > 0)) break;
      const double next = s - f / slope;
      if (!(next > s)) break;
      s = next;
    }
    return s;
  }
  /// In the middle plane and deep inside: F has no root. The nearest points lie on either side; here is the upper one.
  [[nodiscard]] bool between_two(std::array<double, 3>& x) const {
    if (start() > 0) return false;
    double rest = 1;
    int shortest = 0;
    for (int i = 0; i < 3; ++i) {
      if (gap[i] == 0) shortest = i;
      x[i] = gap[i] > 0 ? e[i] * e[i] * y[i] / gap[i] : 0;
      rest -= (x[i] / e[i]) * (x[i] / e[i]);
    }
    if (rest < 0) return false;
    x[shortest] = e[shortest] * std::sqrt(rest);
    return true;
  }
  [[nodiscard]] std::array<double, 3> nearest() const {
    std::array<double, 3> x{};
    if (between_two(x)) return x;
    const double s = root();
    for (int i = 0; i < 3; ++i) x[i] = y[i] == 0 ? 0 : e[i] * e[i] * y[i] / (s + gap[i]);
    return x;
  }
};

}  // namespace

Nearest nearest_on_ellipsoid(const Vec3d& semi_axes, const Vec3d& p) {
  Octant octant{{semi_axes.x, semi_axes.y, semi_axes.z}, {std::abs(p.x), std::abs(p.y), std::abs(p.z)}, {}};
  const double least = std::min({semi_axes.x, semi_axes.y, semi_axes.z});
  for (int i = 0; i < 3; ++i) {
    octant.gap[i] = (octant.e[i] - least) * (octant.e[i] + least);
    if (octant.y[i] < 1e-13 * octant.e[i]) octant.y[i] = 0;
  }
  const auto x = octant.nearest();
  Nearest result;
  result.point = {std::copysign(x[0], p.x), std::copysign(x[1], p.y), std::copysign(x[2], p.z)};
  const Vec3d unit{result.point.x / semi_axes.x, result.point.y / semi_axes.y, result.point.z / semi_axes.z};
  const Vec3d slope{unit.x / semi_axes.x, unit.y / semi_axes.y, unit.z / semi_axes.z};
  result.normal = (1 / norm(slope)) * slope;
  result.distance = dot(p - result.point, result.normal);
  return result;
}

}  // namespace murosimf::geometry
