#include "murosimf/collision/contact_laws/new_name.h"

#include "murosimf/collision/contact_laws/contact_law_parts.h"

namespace murosimf::collision {

// Both bodies feel the same force at the same point: nothing is won or lost of momentum and its moment.
void NewName::push(std::vector<MovingEntity>& entities, PairSet& set, double dt, ParallelFor&) noexcept {
  for (PairContact& c : set.points) {
    c.force = spring_force(set.parameters[c.surface], c.depth, dot(c.velocity, c.normal)) * c.normal;
    entities[c.a].push(c.object, c.point, c.force, dt);
    entities[c.b].push(c.object_b, c.point, -c.force, dt);
  }
}

}  // namespace murosimf::collision
