/// contact_law_parts.h - parts of the contact force that several laws share, and which points the paper's laws keep.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "murosimf/collision/contact.h"

namespace murosimf::collision {

/// No force, no moment, and none of their dampings.
inline void clear_force(ContactPoint& c) noexcept {
  c.force = c.moment = {};
  c.normal_damping = c.tangent_damping = c.angular_damping = c.spin_damping = 0;
}

/// Normal force [N] of a damped spring that cannot pull, explicit: max(0, k depth - d v_n); v_n [m/s] of separation.
[[nodiscard]] inline double spring_force(const ContactParameters& p, double depth, double v_n) noexcept {
  return std::max(0.0, p.stiffness * depth - p.damping * v_n);
}

/// `force` against its direction, as a unit vector: where a body slides if this friction does not hold it. Zero for a
/// force of zero. `size` [N] = norm(force).
[[nodiscard]] inline Vec3d sliding_direction(const Vec3d& force, double size) noexcept {
  return size > 0 ? (-1.0 / size) * force : Vec3d{};
}

/// Largest friction [N] against sliding towards the unit vector `direction`, under the normal force f_n [N]:
/// mu f_n (1 - friction_direction . direction). Only its size depends on the direction; it acts straight against the motion.
/// Differs: friction of real anisotropic surfaces has a part across the motion too, the derivative of its size by the
///          direction ("Anisotropic friction: assessment of force components and resulting trajectories", EPJ
///          Techniques and Instrumentation 3, 2016). It is left out: it would make the damping of sliding unsymmetric.
[[nodiscard]] inline double friction_limit(const ContactParameters& p, double f_n, const Vec3d& direction) noexcept {
  return p.friction * f_n * (1 - dot(p.friction_direction, direction));
}

/// Resistance of a round body that is pressed with f_n [N] to rolling and spinning, as dampings [N m s]: with w_t and w_n the parts of
/// its angular velocity across and along n
///
///     moment = -rolling r f_n (1 - rolling_direction . u) w_t / |w_t| - torsional f_n w_n / |w_n|,     u = w_t x n / |w_t|
///
/// u is where the body rolls to: with a pile that leans along x and rolling_direction = g x, a ball rolls as far as 1 / (1 - g cos a)
/// says. Only the size depends on the direction: nothing turns the ball's way. Both fall linearly to zero below 0.5 rad/s, and the
/// part of the direction with them. Zero for corners.
inline void resist_turning(ContactPoint& c, const ContactParameters& p, double f_n) noexcept {
  constexpr double slow_turn = 0.5;  // [rad/s]
  if (c.radius == 0 || (p.rolling == 0 && p.torsional == 0)) return;
  const double spin = dot(c.angular_velocity, c.normal);
  const Vec3d roll = c.angular_velocity - spin * c.normal;
  const double rate = std::max(norm(roll), slow_turn);
  const double share = 1 - dot(p.rolling_direction, cross(roll, c.normal)) / rate;
  c.angular_damping = p.rolling * c.radius * f_n * share / rate;
  c.spin_damping = p.torsional * f_n / std::max(std::abs(spin), slow_turn);
  c.moment = -c.angular_damping * roll - c.spin_damping * spin * c.normal;
}

/// One point for everything that touches: the deepest, as in the paper (5.3, "there is only one contact point").
/// Keeps the deepest of those points that belong together, the first of equals; then sorts them by `before`.
template <class Point, class Together, class Before>
void keep_deepest(std::vector<Point>& points, Together together, Before before) {
  auto end = points.begin();  // of those that are kept
  for (const Point& point : points) {
    const auto best = std::find_if(points.begin(), end, [&](const Point& other) { return together(point, other); });
    if (best == end) {
      *end++ = point;
    } else if (point.depth > best->depth) {
      *best = point;
    }
  }
  points.erase(end, points.end());
  std::sort(points.begin(), points.end(), before);
}

}  // namespace murosimf::collision
