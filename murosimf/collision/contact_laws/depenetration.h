/// depenetration.h - what is found deep inside something is lifted out slowly instead of being shot out by its spring.
///
/// A point is deep if its first depth is more than its approach explains: depth > 1.5 |v_n| dt + 2 mm. It was put there: at the
/// start, by an event, by a kinematic robot, by other constants. While its spring would let it out faster than
/// `lift`, its damping is
///
///     b = k depth / lift > b_n        f_n = k depth - b v_n = k depth (1 - v_n / lift)
///
/// with the depth taken for 2 mm at most, so that contact does not push what already leaves with that speed. The force stays linear
/// in the velocity, and the law and the island solver take it as any other. An explicit law would overshoot within a step: there a point
/// pushes no harder than brings a tenth of the mass m_p (contact_parameters.h) to that speed, since many more than
/// n_c points may be deep, and points of light limbs.
#pragma once

#include <algorithm>
#include <limits>

#include "murosimf/collision/contact_laws/bounce.h"
#include "murosimf/collision/contact_point.h"

namespace murosimf::collision {

inline constexpr double felt_depth = 2e-3;  ///< [m] more than curved shapes and turning edges have of themselves
inline constexpr double depenetration_speed = 0.5;  ///< [m/s] of what was found deep inside something

/// b_n [N s/m] of a law that is implicit in the velocity after the step.
[[nodiscard]] inline double implicit_damping(const ContactPoint& c, const ContactParameters& p, double dt) noexcept {
  if (is_bouncing(c)) return bounce_damping(p, dt);
  const double b_n = p.damping + p.theta * dt * p.stiffness;
  return c.lift > 0 ? std::max(b_n, p.stiffness * c.depth / c.lift) : b_n;
}

/// [N] of that law on a point that would not move along the normal: f_n = resting_force - b_n v_n+.
[[nodiscard]] inline double resting_force(const ContactPoint& c, const ContactParameters& p, double dt) noexcept {
  return is_bouncing(c) ? bounce_damping(p, dt) * c.bounce : p.stiffness * c.depth;
}

/// b_t [N s/m] of that law while a point sticks.
[[nodiscard]] inline double implicit_tangent_damping(const ContactPoint& c, const ContactParameters& p,
                                                     double dt) noexcept {
  return is_bouncing(c) ? bounce_damping(p, dt) : p.tangent_damping + dt * p.tangent_stiffness;
}

/// Largest force [N] of an explicit law on a point that leaves with v_n [m/s].
[[nodiscard]] inline double explicit_limit(const ContactPoint& c, const ContactParameters& p, double dt,
                                           double v_n) noexcept {
  constexpr double share = 0.1;
  if (c.lift == 0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, share * p.mass * (c.lift - v_n) / dt);
}

/// For a point of something that touched nothing there in the step before; its velocity and depth are known.
inline void begin_depenetration(ContactPoint& c, double dt) noexcept {
  const double approach = std::max(0.0, -dot(c.velocity, c.normal));
  if (c.depth > 1.5 * approach * dt + felt_depth) c.lift = depenetration_speed;
  if (c.lift > 0) c.depth = std::min(c.depth, felt_depth);
}

/// Frees a point again where its spring is slower by itself.
inline void end_depenetration(ContactPoint& c, const ContactParameters& p, double dt) noexcept {
  if (c.depth < felt_depth && p.stiffness * c.depth <= c.lift * (p.damping + p.theta * dt * p.stiffness)) c.lift = 0;
  if (c.lift > 0) c.depth = std::min(c.depth, felt_depth);
}

}  // namespace murosimf::collision
