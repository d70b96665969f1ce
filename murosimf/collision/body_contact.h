/// body_contact.h - algorithm: contact between entities that move.
///
/// Runs after the contact of every entity with the ground and before their motion. Finds the bodies that touch
/// (pair_finder.h) and lets the scene's law push them (body_contact_law.h).
///
/// An entity that cannot be pushed (`dynamic` 0: kinematic walking) feels nothing; what it should have felt is added
/// to its ledger `absorbed_impulse`, so that the momentum of all together with the ledger stays constant. Two of them, or
/// one and a goal, are kept apart by their places (kinematic_separation.h).
/// Source: paper 5; mixed levels measured with the project's prototype.
#pragma once

#include <memory>
#include <vector>

#include "murosimf/collision/body_contact_law.h"
#include "murosimf/collision/pair_finder.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/model/algorithm.h"

namespace murosimf::collision {

class BodyContact final : public Algorithm {
 public:
  /// `setup` is that of an entity that never moves (the field). Ground contact of the moving entities must be attached before,
  /// their motion after it, all at the same rate.
  BodyContact(Setup& setup, const std::vector<Entity*>& moving_entities, const MaterialTable& materials,
              std::unique_ptr<BodyContactLaw> law);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::contact; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  void state(StateArchive& archive) override;

 private:
  std::unique_ptr<BodyContactLaw> law_;
  std::vector<MovingEntity> moving_entities_;
  PairFinder finder_;
  double period_;  // [s]
  PairSet& set_;
  StaticCompound environment_;
};

}  // namespace murosimf::collision
