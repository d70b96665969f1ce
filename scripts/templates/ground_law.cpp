#include "murosimf/collision/contact_laws/new_name.h"

#include "murosimf/collision/contact_laws/contact_law_parts.h"

namespace murosimf::collision {

// An implicit law gives points their dampings here, too (contact_point.h): the level then solves with them.
void NewName::prepare(std::vector<ContactPoint>& points, const ContactTerms& terms) const noexcept {
  for (ContactPoint& c : points) {
    clear_force(c);
    c.last_normal_force = spring_force(terms.parameters[c.surface], c.depth, dot(c.velocity, c.normal));
    c.state = c.last_normal_force > 0 ? ContactState::slip : ContactState::open;
    c.force = c.last_normal_force * c.normal;
  }
}

}  // namespace murosimf::collision
