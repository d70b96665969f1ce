#include "murosimf/scene/contact_marks.h"

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/contact.h"
#include "murosimf/world/world.h"

namespace murosimf::scene {

void add_contact_marks(const World& world, std::vector<ContactMark>& marks) {
  const auto add = [&](const auto& points, int entity) {
    for (const collision::ContactPoint& point : points) marks.push_back({point.point, point.force, entity});
  };
  int number = 0;
  for (const auto& entity : world.entities()) {
    const auto* ground = entity->present() ? entity->find(collision::contacts) : nullptr;
    if (ground) add(ground->values[0].points, number);
    ++number;
  }
  // forces between entities belong to two of them: -1
  if (const auto* pairs = world.common().find(collision::pair_contacts)) add(pairs->values[0].points, -1);
}

}  // namespace murosimf::scene
