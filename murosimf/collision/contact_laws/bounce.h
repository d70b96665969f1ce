/// bounce.h - round bodies bounce by an impulse, so that their restitution is right at steps of any length.
///
/// A bounce of a ball lasts for some milliseconds, which long steps do not resolve. The algorithm that finds a new point of a round body that comes
/// faster than 0.1 m/s therefore gives it the velocity with which it leaves, at the end of this step (Newton's law of impact):
///
///     u_n+ = e u_n-         f_n = b (u_n+ - v_n+) >= 0,  b = 10^6 m_p / dt
///
/// with Coulomb's cone for the impulse along the surface; b is so large that v_n+ misses u_n+ by a millionth of its change. The force stays linear in the velocity, so laws and the island solver take it
/// as any other. On static ground the body is found at the depth delta already, and gravity, g_n into the surface, has changed its
/// velocity since the touch and will do so until it is out again. Semi-implicit Euler's places lie on the parabola of u = v - g_n dt / 2, so
///
///     u_-^2 = (v_- + g_n dt/2)^2 - 2 g_n delta,    v_+ = sqrt(e^2 u_-^2 + 2 g_n delta) - g_n dt/2
///
/// gives the height e^2 h of a fall from h. e counts as 0.005 at least: a dead ball that has come into a wall by a part of a step would
/// else stop there, and its spring throw it out again, with 0.08 of 3 m/s in steps of 1 ms and 0.57 in steps of 10 ms. After that step
/// the point leaves freely, and only is not let in any deeper; if it comes to rest there, its spring takes over. Nothing gains energy at
/// one point; several at once may, as all of Newton's impacts with friction (Kane, "A dynamics puzzle", Stanford Mechanics Alumni Club
/// Newsletter, 1984).
/// Source: Brach, Mechanical Impact Dynamics, 1991, ch. 2 (Newton's and Coulomb's law); the depth: conservation of energy.
#pragma once

#include <algorithm>
#include <cmath>

#include "murosimf/collision/contact_point.h"

namespace murosimf::collision {

inline constexpr double slowest_bounce = 0.1;       ///< [m/s] what comes slower is stopped by its spring
inline constexpr double least_restitution = 0.005;  ///< [1] of what is not stopped by its spring

/// In a bounce or on its way out of it.
[[nodiscard]] inline bool is_bouncing(const ContactPoint& c) noexcept { return c.bounce >= 0; }

/// b [N s/m].
[[nodiscard]] inline double bounce_damping(const ContactParameters& p, double dt) noexcept { return 1e6 * p.mass / dt; }

/// For a point that touched nothing in the step before; its velocity and depth are known. `gravity` [m/s^2] of the body against what it
/// touches, world frame.
inline void begin_bounce(ContactPoint& c, const ContactParameters& p, const Vec3d& gravity, double dt) noexcept {
  if (p.restitution < 0 || c.lift > 0) return;
  const double into = -dot(gravity, c.normal), within_step = 0.5 * into * dt;
  const double approach = within_step - dot(c.velocity, c.normal);
  if (approach <= slowest_bounce) return;
  const double fallen = 2 * into * c.depth;
  const double impact = std::max(0.0, approach * approach - fallen);
  const double e = std::max(p.restitution, least_restitution);
  const double leaves = std::max(0.0, e * e * impact + fallen);
  c.bounce = std::max(0.0, std::sqrt(leaves) - within_step);
}

/// For a point that was bouncing in the step before.
inline void go_on_bouncing(ContactPoint& c) noexcept {
  if (!is_bouncing(c)) return;
  c.bounce = dot(c.velocity, c.normal) > 0 ? 0 : -1;
  c.state = ContactState::open;
  c.stretch = c.slip_direction = {};
  c.last_normal_force = 0;
}

}  // namespace murosimf::collision
