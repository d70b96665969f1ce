#include "murosimf/collision/touches.h"

#include "murosimf/collision/body_pairs.h"

namespace murosimf::collision {
namespace {

/// As A of the contact feels it.
Touch touch_of(const Entity& entity, const ContactPoint& c, const Entity* other, int other_object) {
  return {&entity, c.object, other, other_object, c.point, c.normal, c.force, c.depth};
}

Touch seen_from_other(const Touch& touch) {
  return {touch.other, touch.other_object, touch.entity, touch.object,
          touch.point, -touch.normal,      -touch.force, touch.depth};
}

const Entity* entity_at(const World& world, int number) {
  return number < 0 ? nullptr : world.entities()[static_cast<std::size_t>(number)].get();
}

void add_static(const World& world, const Entity& entity, std::vector<Touch>& found) {
  const auto* column = entity.find(contacts);
  if (!column) return;
  const ContactSet& set = column->values[0];
  for (const ContactPoint& c : set.points) {
    found.push_back(touch_of(entity, c, entity_at(world, set.environment), set.environment_objects[c.surface]));
  }
}

void add_pairs(const World& world, const PairSet& set, const Entity& entity, std::vector<Touch>& found) {
  for (const PairContact& c : set.points) {
    const Entity* a = entity_at(world, set.entities[static_cast<std::size_t>(c.a)]);
    const Entity* b = entity_at(world, set.entities[static_cast<std::size_t>(c.b)]);
    const Touch touch = touch_of(*a, c, b, c.object_b);
    if (a == &entity) found.push_back(touch);
    if (b == &entity) found.push_back(seen_from_other(touch));
  }
}

}  // namespace

std::vector<Touch> touches(const World& world, const Entity& entity) {
  std::vector<Touch> found;
  if (entity.idle()) return found;
  add_static(world, entity, found);
  if (const auto* pairs = world.common().find(pair_contacts)) add_pairs(world, pairs->values[0], entity, found);
  return found;
}

}  // namespace murosimf::collision
