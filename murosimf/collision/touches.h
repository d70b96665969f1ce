/// touches.h - what an entity touches: which bodies, where, and with which force. For sensors and users.
///
///     for (const Touch& touch : touches(world, robot)) {
///       if (touch.other == &ball) fmt::print("kicked with {} N\n", norm(touch.force));
///     }
///
/// The points are those of the last step: found where bodies were at its beginning, with the force that acted until its
/// end. With the law `carry` between bodies it is the force at the beginning (body_contact_law.h). Bodies that overlap without a
/// force, because they part faster than their contact springs back, are listed with force 0. Kinematic walkers that are
/// kept apart (kinematic_separation.h) touch neither each other nor static shapes: no force acts there.
#pragma once

#include <vector>

#include "murosimf/world/world.h"

namespace murosimf::collision {

/// One point of contact. Several belong to one pair of bodies where a flat side rests.
struct Touch {
  const Entity* entity = nullptr;
  int object = 0;                 ///< body of `entity`
  const Entity* other = nullptr;  ///< the environment, another entity, or `entity` itself
  int other_object = 0;           ///< body of `other`
  Vec3d point;                    ///< [m] world frame
  Vec3d normal;                   ///< [1] unit, world frame, from `other` to `entity`
  Vec3d force;                    ///< [N] on `entity` at `point`, world frame; `other` feels its opposite
  double depth = 0;               ///< [m] overlap along the normal, positive
};

/// Contacts with the environment first, in an order that stays the same while they last; then those with bodies that
/// move. A point where the entity touches itself is listed for both of its bodies, one after the other. A frozen entity
/// touches nothing.
[[nodiscard]] std::vector<Touch> touches(const World& world, const Entity& entity);

}  // namespace murosimf::collision
