/// body_island_law.h - law between moving bodies: all contacts of touching entities are settled together; the default.
///
/// Every island of touching entities is solved here: each member makes its free pass, its contacts with the ground and with the
/// others become rows (island_solver.h), and motion takes the result over. Contacts with the ground become rows if their law
/// has the same force and memory (implicit_stick), so an entity changes between its own law and an island from step to step
/// without a jump; explicit laws keep their force, and only contacts between bodies are rows. Contacts between entities that
/// cannot answer a solver push explicitly (body_kelvin_voigt_law.h).
#pragma once

#include <vector>

#include "murosimf/collision/body_contact_law.h"
#include "murosimf/collision/island_solver.h"
#include "murosimf/collision/islands.h"

namespace murosimf::collision {

struct BodyIslandOptions {
  int sweeps = 10;  ///< of the solver in a step, at most
};

class BodyIslandLaw final : public BodyContactLaw {
 public:
  explicit BodyIslandLaw(const BodyIslandOptions& options = {}) : sweeps_(options.sweeps) {}

  [[nodiscard]] bool implicit() const noexcept override { return true; }
  void push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt) noexcept override;

 private:
  void solve(int island, std::vector<MovingEntity>& moving_entities, PairSet& set, double dt) noexcept;
  [[nodiscard]] int start_member(MovingEntity& moving_entity, double dt) noexcept;
  void finish_member(MovingEntity& moving_entity, bool island_stands) noexcept;
  [[nodiscard]] IslandSolver::Side side(int moving_entity, int object, const Vec3d& velocity) const;

  int sweeps_;
  Islands islands_;
  IslandSolver solver_;
  std::vector<int> member_;           // by moving entity: its number in the solver of its island, or below 0
  std::vector<Vec3d> next_velocity_;  // [m/s] of the points of one member after the step
};

}  // namespace murosimf::collision
