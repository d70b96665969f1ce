#include "murosimf/collision/contact_laws/deferred_impulse_law.h"

#include "murosimf/collision/contact_laws/contact_law_parts.h"
#include "murosimf/collision/contact_laws/depenetration.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

/// b_n n n^T + b_t (1 - n n^T).
SymMat3d damping_of(const PairContact& c) {
  return diagonal(c.tangent_damping) + (c.normal_damping - c.tangent_damping) * outer(c.normal);
}

/// Force at the present velocity, and the dampings; the spring first follows the motion of the preceding step.
void find_carry_force(PairContact& c, const ContactParameters& p, double dt) {
  MUROSIMF_ASSERT(dt > 0);
  const double v_n = dot(c.velocity, c.normal);
  const Vec3d v_t = c.velocity - v_n * c.normal;
  c.stretch = tangential(c.stretch, c.normal);
  if (c.state == ContactState::stick) c.stretch += dt * v_t;
  clear_force(c);
  const double b_n = implicit_damping(c, p, dt), b_t = implicit_tangent_damping(c, p, dt);
  const double f_n = resting_force(c, p, dt) - b_n * v_n;
  if (f_n <= 0) {
    c.state = ContactState::open;
    c.stretch = {};
    return;
  }
  c.normal_damping = b_n;
  const Vec3d sticking = -p.tangent_stiffness * c.stretch - b_t * v_t;
  const double size = norm(sticking);
  const Vec3d direction = sliding_direction(sticking, size);
  const double limit = friction_limit(p, f_n, direction);
  if (size <= limit) {
    c.state = ContactState::stick;
    c.tangent_damping = b_t;
    c.force = f_n * c.normal + sticking;
  } else {
    c.state = ContactState::slip;
    c.force = f_n * c.normal - limit * direction;
    c.stretch = (limit / p.tangent_stiffness) * direction - (p.tangent_damping / p.tangent_stiffness) * v_t;
  }
}

/// Reverts what the contacts of the preceding step have left over: -e/2 for either side, or the ledger of an immovable side.
void take_back(std::vector<MovingEntity>& moving_entities, const PairContact& old, double dt) {
  MovingEntity &a = moving_entities[old.a], &b = moving_entities[old.b];
  const SymMat3d damping = damping_of(old);
  const Vec3d lost_a = damping * (a.velocity_at(old.object, old.arm_a) - old.velocity_a);  // B a_A
  const Vec3d lost_b = damping * (b.velocity_at(old.object_b, old.arm_b) - old.velocity_b);
  if (!a.can_be_pushed()) return a.push(old.object, old.point, old.force + lost_b, dt);
  if (!b.can_be_pushed()) return b.push(old.object_b, old.point, lost_a - old.force, dt);
  const Vec3d half = 0.5 * (lost_a + lost_b);
  a.push(old.object, old.point, half, dt);
  b.push(old.object_b, old.point, half, dt);
}

}  // namespace

void DeferredImpulseLaw::push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
                              ParallelFor&) noexcept {
  for (const PairContact& old : set.previous) {
    if (old.state != ContactState::open) take_back(moving_entities, old, dt);
  }
  for (PairContact& c : set.points) {
    MUROSIMF_ASSERT(c.surface < set.parameters.size());
    find_carry_force(c, set.parameters[c.surface], dt);
    if (c.state == ContactState::open) continue;
    MovingEntity &a = moving_entities[c.a], &b = moving_entities[c.b];
    if (a.can_be_pushed()) {
      a.push(c.object, c.point, c.force, dt);
      a.damp(c.object, c.point, damping_of(c));
    }
    if (b.can_be_pushed()) {
      b.push(c.object_b, c.point, -c.force, dt);
      b.damp(c.object_b, c.point, damping_of(c));
    }
  }
}

}  // namespace murosimf::collision
