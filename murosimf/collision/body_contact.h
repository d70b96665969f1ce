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

#include "murosimf/collision/contact_laws/body_contact_law.h"
#include "murosimf/collision/pair_finder.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/world/algorithm.h"

namespace murosimf::collision {

class BodyContact final : public Algorithm {
 public:
  /// Of the world. `environment`: what stands still (the field), null if nothing does. Ground contact and motion of the moving
  /// entities must have the same rate.
  BodyContact(Setup& setup, const Entity* environment, const std::vector<Entity*>& moving_entities,
              const MaterialTable& materials, std::unique_ptr<BodyContactLaw> law);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::interaction; }
  void initialize() override;
  /// Takes it for one that moves.
  void entity_added(Setup& setup) override;
  void entity_taken_back(const Entity& entity) noexcept override;
  void entity_entered(const Entity& entity) override;
  void model_exchanged(const Entity& entity) override;
  /// From the next step on; points keep their memory. To be called between steps.
  void exchange_materials(const MaterialTable& materials);
  void step(const Instant& instant) noexcept override;
  void state(StateArchive& archive) override;

 private:
  void start(MovingEntity& moving_entity);
  void renumber_surfaces();

  std::unique_ptr<BodyContactLaw> law_;
  std::vector<MovingEntity> moving_entities_;
  PairFinder finder_;
  double period_;  // [s]
  Vec3d gravity_;  // [m/s^2] world
  PairSet& set_;
  std::shared_ptr<const StaticCompound> environment_;
};

}  // namespace murosimf::collision
