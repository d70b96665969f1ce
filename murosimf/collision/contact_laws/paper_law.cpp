#include "murosimf/collision/contact_laws/paper_law.h"

#include <algorithm>

#include "murosimf/collision/contact_laws/contact_law_parts.h"
#include "murosimf/collision/contact_laws/depenetration.h"

namespace murosimf::collision {
PaperForce paper_force(const ContactPoint& c, const ContactParameters& p, double dt,
                       const PaperLawOptions& options) noexcept {
  const double v_n = dot(c.velocity, c.normal);
  const double gain = v_n < 0 ? 1.0 : options.rebound.value_or(p.rebound);
  const double f_n = std::min(gain * p.stiffness * c.depth, explicit_limit(c, p, dt, v_n));
  return {f_n, options.friction.value_or(p.viscous_friction) * f_n,
          options.spin_friction.value_or(p.spin_friction) * f_n};
}

void PaperLaw::prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept {
  if (options_.one_point_per_body) {
    keep_deepest(
        points, [](const ContactPoint& a, const ContactPoint& b) { return a.object == b.object; },
        [](const ContactPoint& a, const ContactPoint& b) { return a.feature < b.feature; });
  }
  for (ContactPoint& c : points) {
    clear_force(c);
    const PaperForce f = paper_force(c, terms.parameters[c.surface], terms.dt, options_);
    c.force = f.normal * c.normal - f.rub * tangential(c.velocity, c.normal);
    c.moment = -f.spin * c.angular_velocity;
    if (!options_.bounded) continue;
    c.slip_direction = {};
    c.tangent_damping = f.rub;
    c.angular_damping = c.spin_damping = f.spin;
  }
}

void PaperLaw::commit(std::span<ContactPoint> points, const ContactTerms&,
                      std::span<const Vec3d> next_velocity) const noexcept {
  for (std::size_t i = 0; i < points.size(); ++i) {
    ContactPoint& c = points[i];
    c.force -= c.tangent_damping * tangential(next_velocity[i] - c.velocity, c.normal);
  }
}

}  // namespace murosimf::collision
