#include "murosimf/collision/contact_laws/kelvin_voigt_law.h"

#include <algorithm>

#include "murosimf/collision/contact_laws/contact_law_parts.h"
#include "murosimf/collision/contact_laws/depenetration.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

/// Friction at the beginning of the step; decides whether the point sticks.
Vec3d friction(ContactPoint& c, const ContactParameters& p, double f_n, const Vec3d& v_t) {
  const Vec3d sticking = -p.tangent_stiffness * c.stretch - p.tangent_damping * v_t;
  const double size = norm(sticking);
  const Vec3d direction = sliding_direction(sticking, size);
  const double limit = friction_limit(p, f_n, direction);
  c.state = size <= limit ? ContactState::stick : ContactState::slip;
  return c.state == ContactState::stick ? sticking : -limit * direction;
}

void find_force(ContactPoint& c, const ContactParameters& p, double dt) {
  clear_force(c);
  c.stretch = tangential(c.stretch, c.normal);
  const double v_n = dot(c.velocity, c.normal);
  const double f_n = std::min(spring_force(p, c.depth, v_n), explicit_limit(c, p, dt, v_n));
  c.last_normal_force = f_n;
  if (f_n == 0) {
    c.state = ContactState::open;
    return;
  }
  c.force = f_n * c.normal + friction(c, p, f_n, c.velocity - v_n * c.normal);
  resist_turning(c, p, f_n);
  c.angular_damping = c.spin_damping = 0;  // this law is explicit
}

}  // namespace

void KelvinVoigt::prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept {
  MUROSIMF_ASSERT(terms.dt > 0);
  for (ContactPoint& c : points) {
    MUROSIMF_ASSERT(c.surface < terms.parameters.size());
    find_force(c, terms.parameters[c.surface], terms.dt);
  }
}

void KelvinVoigt::commit(std::span<ContactPoint> points, const ContactTerms& terms,
                         std::span<const Vec3d> next_velocity) const noexcept {
  MUROSIMF_ASSERT(next_velocity.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ContactPoint& c = points[i];
    MUROSIMF_ASSERT(c.surface < terms.parameters.size());
    const ContactParameters& p = terms.parameters[c.surface];
    if (c.state == ContactState::open) {
      c.stretch = {};
      continue;
    }
    // back onto the cone: the spring holds what the present friction force needs
    if (c.state == ContactState::slip) {
      const Vec3d f_t = tangential(c.force, c.normal), v_t = tangential(c.velocity, c.normal);
      c.stretch = (-1.0 / p.tangent_stiffness) * (f_t + p.tangent_damping * v_t);
    }
    c.stretch += terms.dt * tangential(next_velocity[i], c.normal);
  }
}

}  // namespace murosimf::collision
