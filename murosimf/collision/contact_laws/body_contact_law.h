/// body_contact_law.h - how two moving bodies push each other: the exchangeable part of body_contact.h, one for a whole scene.
///
/// All keep the law of action and reaction: at every instant, or summed over time (deferred_impulse_law.h).
#pragma once

#include <vector>

#include "murosimf/collision/moving_entity.h"
#include "murosimf/model/parallel_for.h"

namespace murosimf::collision {

/// What lasts from step to step is in the points and columns; members of a law are working memory.
class BodyContactLaw {
 public:
  virtual ~BodyContactLaw() = default;

  /// Whether it bears the stiffest contacts that a step resolves (contact_parameters.h).
  [[nodiscard]] virtual bool implicit() const noexcept { return false; }
  /// Whether its forces fall with the velocities that a step ends with (MovingEntity::damp): levels must then answer damping
  /// even without a ground law that does so (ContactInterface::damped_by_others).
  [[nodiscard]] virtual bool damps() const noexcept { return false; }
  /// Gives every point of `set` its force and memory, and all entities what they feel; dt [s] is the length of the step. The
  /// points of the step before are in set.previous.
  virtual void push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
                    ParallelFor& parallel_for) noexcept = 0;
};

}  // namespace murosimf::collision
