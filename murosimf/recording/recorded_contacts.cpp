#include "murosimf/recording/recorded_contacts.h"

#include <cstddef>
#include <utility>

#include "murosimf/collision/body_pairs.h"

namespace murosimf::recording {

void ContactWatch::add(const World& world, std::vector<ContactMark>& marks) {
  const auto add = [&](const auto& points, int entity) {
    for (const collision::ContactPoint& point : points) marks.push_back({point.point, point.force, entity});
  };
  known_.resize(world.entities().size());
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const Entity& entity = *world.entities()[i];
    Known& known = known_[i];
    if (known.entity != &entity || known.level != entity.level) {
      const std::shared_ptr<ColumnBase> before = std::move(known.kept);  // kept alive until the new lookup
      known = {.entity = &entity,
               .level = entity.level,
               .kept = entity.columns().share(collision::contacts.name),
               .column = entity.find(collision::contacts)};
    }
    if (known.column && entity.present()) add(known.column->values[0].points, static_cast<int>(i));
  }
  if (const auto* pairs = world.common().find(collision::pair_contacts)) add(pairs->values[0].points, -1);
}

}  // namespace murosimf::recording
