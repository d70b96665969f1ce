#include "murosimf/collision/contact_laws/implicit_stick_law.h"

#include <algorithm>

#include "murosimf/collision/contact_laws/contact_law_parts.h"
#include "murosimf/collision/contact_laws/depenetration.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

constexpr double slow = 0.005;             // [m/s] below this the direction of sliding is not trusted
constexpr double normal_tolerance = 0.05;  // a sliding force is renewed if the normal force moved by more than this

/// Normal force after a step that ends with the normal velocity v_n.
double normal_force(const ContactPoint& c, const ContactParameters& p, double dt, double v_n) {
  MUROSIMF_ASSERT(dt > 0);
  return resting_force(c, p, dt) - implicit_damping(c, p, dt) * v_n;
}

Vec3d stick_force(const ContactPoint& c, const ContactParameters& p, double dt, const Vec3d& v_t) {
  return -p.tangent_stiffness * c.stretch - implicit_tangent_damping(c, p, dt) * v_t;
}

void linearize_stick(ContactPoint& c, const ContactParameters& p, double dt) {
  const double v_n = dot(c.velocity, c.normal);
  const Vec3d v_t = c.velocity - v_n * c.normal;
  c.normal_damping = implicit_damping(c, p, dt);
  c.tangent_damping = implicit_tangent_damping(c, p, dt);
  c.force = normal_force(c, p, dt, v_n) * c.normal + stick_force(c, p, dt, v_t);
}

/// Friction mu f_n against the sliding velocity; f_n is that of the preceding pass. Its derivative is zero along the
/// direction of sliding and -mu f_n / |v_t| across it; mu counts as constant.
void linearize_slip(ContactPoint& c, const ContactParameters& p, double dt) {
  const double v_n = dot(c.velocity, c.normal);
  const Vec3d v_t = c.velocity - v_n * c.normal;
  const double speed = norm(v_t);
  if (speed > slow) c.slip_direction = (1.0 / speed) * v_t;  // slower, the preceding direction is the better one
  const double limit = friction_limit(p, c.last_normal_force, c.slip_direction);
  c.normal_damping = implicit_damping(c, p, dt);
  c.tangent_damping = limit / std::max(speed, slow);
  const Vec3d across = v_t - dot(v_t, c.slip_direction) * c.slip_direction;
  c.force = normal_force(c, p, dt, v_n) * c.normal - limit * c.slip_direction - c.tangent_damping * across;
}

void linearize(ContactPoint& c, const ContactParameters& p, double dt) {
  if (c.state == ContactState::open) return clear_force(c);
  if (c.state == ContactState::slip) {
    linearize_slip(c, p, dt);
  } else {
    linearize_stick(c, p, dt);
  }
  if (!is_bouncing(c)) resist_turning(c, p, p.stiffness * c.depth);
}

/// Friction of the present linearization for the tangential velocity v_t after the step.
Vec3d tangential_force(const ContactPoint& c, const Vec3d& v_t) {
  Vec3d change = v_t - tangential(c.velocity, c.normal);
  if (c.state == ContactState::slip) change -= dot(change, c.slip_direction) * c.slip_direction;
  return tangential(c.force, c.normal) - c.tangent_damping * change;
}

/// State of a point that closes with the velocity v: it slides if it moves along the surface, otherwise it sticks. A trial step
/// that stops a sliding point in vain would give no information about its neighbors. Its friction begins with the normal force of that
/// trial: the force of spring and damper for v would be that on a body of infinite mass, and would throw a light foot back.
void close(ContactPoint& c, const Vec3d& v) {
  const double v_n = dot(v, c.normal);
  const Vec3d v_t = v - v_n * c.normal;
  const double speed = norm(v_t);
  if (speed <= slow) {
    c.state = ContactState::stick;
    return;
  }
  c.state = ContactState::slip;
  c.slip_direction = (1 / speed) * v_t;
  c.last_normal_force = 0;
}

/// Decides about one point; true if the decision agrees with the trial step.
bool accept_point(ContactPoint& c, const ContactParameters& p, double dt, const Vec3d& next) {
  const double v_n = dot(next, c.normal);
  const Vec3d v_t = next - v_n * c.normal;
  const double f_n = normal_force(c, p, dt, v_n);
  const ContactState before = c.state;

  if (f_n < 0) {
    c.state = ContactState::open;
    return before == ContactState::open;
  }
  if (before == ContactState::open) {
    close(c, next);
    return false;
  }
  if (before == ContactState::stick) {
    const Vec3d f_t = stick_force(c, p, dt, v_t);
    const double size = norm(f_t);
    const Vec3d direction = sliding_direction(f_t, size);
    if (size <= friction_limit(p, f_n, direction)) return true;
    c.state = ContactState::slip;
    c.last_normal_force = f_n;
    c.slip_direction = direction;
    return false;
  }
  // slipping: friction that would push along the motion means that the point has come to rest
  // (without friction the sign is that of a rounding error)
  if (p.friction > 0 && dot(tangential_force(c, v_t), v_t) > 0) {
    c.state = ContactState::stick;
    return false;
  }
  const bool moved = std::abs(f_n - c.last_normal_force) > normal_tolerance * std::max(f_n, c.last_normal_force);
  c.last_normal_force = f_n;
  return !moved;
}

}  // namespace

void ImplicitStick::prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept {
  MUROSIMF_ASSERT(terms.dt > 0);
  for (ContactPoint& c : points) {
    MUROSIMF_ASSERT(c.surface < terms.parameters.size());
    const ContactParameters& p = terms.parameters[c.surface];
    c.stretch = tangential(c.stretch, c.normal);
    // a bouncing point leaves by its impulse
    if (c.state == ContactState::open && !is_bouncing(c)) close(c, c.velocity);
    linearize(c, p, terms.dt);
  }
}

bool ImplicitStick::accept(std::span<ContactPoint> points, const ContactTerms& terms,
                           std::span<const Vec3d> next_velocity) const noexcept {
  MUROSIMF_ASSERT(next_velocity.size() == points.size());
  bool agreed = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ContactPoint& c = points[i];
    const ContactParameters& p = terms.parameters[c.surface];
    if (accept_point(c, p, terms.dt, next_velocity[i])) continue;
    linearize(c, p, terms.dt);
    agreed = false;
  }
  return agreed;
}

void ImplicitStick::commit(std::span<ContactPoint> points, const ContactTerms& terms,
                           std::span<const Vec3d> next_velocity) const noexcept {
  MUROSIMF_ASSERT(next_velocity.size() == points.size());
  MUROSIMF_ASSERT(terms.dt > 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ContactPoint& c = points[i];
    MUROSIMF_ASSERT(c.surface < terms.parameters.size());
    const ContactParameters& p = terms.parameters[c.surface];
    const double v_n = dot(next_velocity[i], c.normal);
    const Vec3d v_t = next_velocity[i] - v_n * c.normal;
    const double f_n = normal_force(c, p, terms.dt, v_n);
    // passes may have been exhausted before the law agreed: a force never pulls
    if (c.state == ContactState::open || f_n < 0) {
      c.state = ContactState::open;
      c.stretch = {};
      c.last_normal_force = 0;
      clear_force(c);
      continue;
    }
    const Vec3d f_t = tangential_force(c, v_t);
    if (c.state == ContactState::stick) {
      c.stretch += terms.dt * v_t;
    } else {
      c.stretch = (-1.0 / p.tangent_stiffness) * (f_t + p.tangent_damping * v_t);  // back onto the cone
    }
    c.last_normal_force = f_n;
    c.force = f_n * c.normal + f_t;
  }
}

}  // namespace murosimf::collision
