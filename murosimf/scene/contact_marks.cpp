#include "murosimf/scene/contact_marks.h"

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/contact.h"
#include "murosimf/model/world.h"

namespace murosimf::scene {

void add_contact_marks(const World& world, std::vector<ContactMark>& marks) {
  const auto add = [&](const auto& points) {
    for (const collision::ContactPoint& point : points) marks.push_back({point.point, point.force});
  };
  for (const auto& entity : world.entities()) {
    if (!entity->present()) continue;
    if (const auto* ground = entity->find(collision::contacts)) add(ground->values[0].points);
  }
  if (const auto* pairs = world.common().find(collision::pair_contacts)) add(pairs->values[0].points);
}

}  // namespace murosimf::scene
