#include "murosimf/collision/body_kelvin_voigt_law.h"

#include <algorithm>

#include "murosimf/collision/contact_law_parts.h"
#include "murosimf/collision/soft_start.h"

namespace murosimf::collision {

void BodyKelvinVoigtLaw::push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt, Helpers&) noexcept {
  for (PairContact& c : set.points) push_by_kelvin_voigt(moving_entities, c, set.parameters[c.surface], dt);
}

void push_by_kelvin_voigt(std::vector<MovingEntity>& moving_entities, PairContact& c, const ContactParameters& p,
                          double dt) noexcept {
  const double v_n = dot(c.velocity, c.normal);
  const Vec3d v_t = c.velocity - v_n * c.normal;
  const double slide = norm(v_t);
  const double f_n = std::min(spring_force(p, c.depth, v_n), explicit_limit(c, p, dt, v_n));
  c.force = f_n * c.normal;
  if (slide > 0) c.force -= (std::min(p.friction * f_n, p.tangent_damping * slide) / slide) * v_t;
  moving_entities[c.a].push(c.object, c.point, c.force, dt);
  moving_entities[c.b].push(c.object_b, c.point, -c.force, dt);
}

}  // namespace murosimf::collision
