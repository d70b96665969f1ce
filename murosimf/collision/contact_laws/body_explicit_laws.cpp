#include "murosimf/collision/contact_laws/body_explicit_laws.h"

#include <algorithm>
#include <utility>

#include "murosimf/collision/contact_laws/contact_law_parts.h"
#include "murosimf/collision/contact_laws/depenetration.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

bool of_the_same_bodies(const PairContact& a, const PairContact& b) {
  return a.a == b.a && a.b == b.b && a.object == b.object && a.object_b == b.object_b;
}

bool stands_before(const PairContact& a, const PairContact& b) {
  return std::pair(a.shapes, a.feature) < std::pair(b.shapes, b.feature);
}

Vec3d direction_of(const Vec3d& v) {
  const double size = norm(v);
  return size > 0 ? (1 / size) * v : Vec3d{};
}

/// A damper c for the velocity after a step in which it alone acts on an inverse effective mass S: it cannot turn the motion around.
double bounded(double c, double dt, double S) {
  MUROSIMF_ASSERT(dt > 0);
  return c / (1 + dt * c * S);
}

}  // namespace

void BodyKelvinVoigtLaw::push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
                              ParallelFor&) noexcept {
  for (PairContact& c : set.points) push_by_kelvin_voigt(moving_entities, c, set.parameters[c.surface], dt);
}

void push_by_kelvin_voigt(std::vector<MovingEntity>& moving_entities, PairContact& c, const ContactParameters& p,
                          double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0 && static_cast<std::size_t>(c.a) < moving_entities.size() &&
                  static_cast<std::size_t>(c.b) < moving_entities.size());
  const double v_n = dot(c.velocity, c.normal);
  const Vec3d v_t = c.velocity - v_n * c.normal;
  const double slide = norm(v_t);
  const double f_n = std::min(spring_force(p, c.depth, v_n), explicit_limit(c, p, dt, v_n));
  // friction from the velocity of this instant, at most the force that the damper gives: near rest it does not alternate
  c.force = f_n * c.normal;
  if (slide > 0) c.force -= (std::min(p.friction * f_n, p.tangent_damping * slide) / slide) * v_t;
  moving_entities[c.a].push(c.object, c.point, c.force, dt);
  moving_entities[c.b].push(c.object_b, c.point, -c.force, dt);
}

void BodyPaperLaw::push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt, ParallelFor&) noexcept {
  if (options_.one_point_per_body) keep_deepest(set.points, of_the_same_bodies, stands_before);
  parts_.start();
  touched_.clear();
  for (const PairContact& c : set.points) {
    touched_.push_back(
        {parts_.touch(moving_entities[c.a], c.a, c.object), parts_.touch(moving_entities[c.b], c.b, c.object_b)});
  }
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    MUROSIMF_ASSERT(touched_.size() == set.points.size());
    PairContact& c = set.points[i];
    MovingEntity &a = moving_entities[c.a], &b = moving_entities[c.b];
    c.angular_velocity = a.w[c.object] - b.w[c.object_b];
    const Vec3d v_t = tangential(c.velocity, c.normal);
    PaperForce f = paper_force(c, set.parameters[c.surface], dt, options_);
    if (options_.bounded) {
      const Vec3d along = direction_of(v_t), about = direction_of(c.angular_velocity);
      const auto [at_a, at_b] = touched_[i];
      f.rub = bounded(f.rub, dt, parts_.along(at_a, c.point, along) + parts_.along(at_b, c.point, along));
      f.spin = bounded(f.spin, dt, parts_.about(at_a, about) + parts_.about(at_b, about));
    }
    clear_force(c);
    c.force = f.normal * c.normal - f.rub * v_t;
    c.moment = -f.spin * c.angular_velocity;
    a.push(c.object, c.point, c.force, dt);
    a.turn(c.object, c.moment, dt);
    b.push(c.object_b, c.point, -c.force, dt);
    b.turn(c.object_b, -c.moment, dt);
  }
}

}  // namespace murosimf::collision
