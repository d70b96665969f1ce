/// body_contact.h - algorithm: contact between entities that move.
///
/// Runs after the contact of every entity with the ground and before their motion. Finds the bodies that touch
/// (pair_finder.h) and lets the scene's law push them (body_contact_law.h). With `island_gauss_seidel` every island of touching
/// entities is solved here: each member makes its free pass, its contacts with the ground and with the others become
/// rows (island_solver.h), and motion takes the result over. Contacts with the ground become rows if their law has the
/// same force and memory (implicit_stick), so an entity changes between its own law and an island from step to step
/// without a jump; explicit laws keep their force, and only contacts between bodies are rows.
///
/// An entity that cannot be pushed (`dynamic` 0: kinematic walking) feels nothing; what it should have felt is added
/// to its ledger `absorbed_impulse`, so that the momentum of all together with the ledger stays constant. Two of them, or
/// one and a goal, are kept apart by their places (kinematic_separation.h).
/// Source: paper 5; mixed levels measured with the project's prototype.
#pragma once

#include <vector>

#include "murosimf/collision/body_contact_law.h"
#include "murosimf/collision/island_solver.h"
#include "murosimf/collision/islands.h"
#include "murosimf/collision/pair_finder.h"
#include "murosimf/collision/static_compound.h"
#include "murosimf/model/algorithm.h"

namespace murosimf::collision {

struct BodyContactOptions {
  BodyContactLaw law = BodyContactLaw::island_gauss_seidel;
  int sweeps = 10;  ///< of the island solver
};

class BodyContact final : public Algorithm {
 public:
  /// `setup` is that of an entity that never moves (the field). Ground contact of the moving entities must be attached before,
  /// their motion after it, all at the same rate.
  BodyContact(Setup& setup, const std::vector<Entity*>& moving_entities, const MaterialTable& materials,
              const BodyContactOptions& options = {});

  [[nodiscard]] Phase phase() const noexcept override { return Phase::contact; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

 private:
  void solve_islands(double dt) noexcept;
  void solve_island(int island, double dt) noexcept;
  [[nodiscard]] int start_member(MovingEntity& moving_entity, double dt) noexcept;
  void finish_member(MovingEntity& moving_entity, bool island_stands) noexcept;
  [[nodiscard]] IslandSolver::Side side(int moving_entity, int object, const Vec3d& velocity) const;

  BodyContactOptions options_;
  std::vector<MovingEntity> moving_entities_;
  PairFinder finder_;
  double period_;  // [s]
  PairSet& set_;
  StaticCompound environment_;
  Islands islands_;
  IslandSolver solver_;
  std::vector<Vec3d> next_velocity_;  // [m/s] of the points of one member after the step; working memory
  std::vector<int> member_;           // by moving_entity: its number in the solver, or below 0
};

}  // namespace murosimf::collision
