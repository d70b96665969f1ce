/// body_island_law.h - law between moving bodies: all contacts of touching entities are settled together; the default.
///
/// Every island of touching entities is solved here: each member makes its free pass, its contacts with the ground and with the
/// others become rows (island_solver.h), and motion takes the result over. Contacts with the ground become rows if their law
/// has the same force and memory (implicit_stick), so an entity changes between its own law and an island from step to step
/// without a jump; explicit laws keep their force, and only contacts between bodies are rows. Contacts between entities that
/// cannot answer a solver push explicitly (body_explicit_laws.h).
///
/// Threads share out the free passes, then the islands, then what motion takes over; in between, the pushes are added up in their order.
#pragma once

#include <vector>

#include "murosimf/collision/contact_laws/body_contact_law.h"
#include "murosimf/collision/contact_laws/island_solver.h"
#include "murosimf/collision/contact_laws/islands.h"

namespace murosimf::collision {

struct BodyIslandOptions {
  int sweeps = 300;  ///< of the solver in a step, at most
};

class BodyIslandLaw final : public BodyContactLaw {
 public:
  explicit BodyIslandLaw(const BodyIslandOptions& options = {}) : sweeps_(options.sweeps) {}

  [[nodiscard]] bool implicit() const noexcept override { return true; }
  void push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
            ParallelFor& parallel_for) noexcept override;

 private:
  /// Of an island.
  struct Island {
    IslandSolver solver;
    bool stands = false;  // on the ground
  };
  /// Of a moving entity.
  struct Member {
    int number = outside;                // in the solver of its island, or below 0
    std::vector<Vec3d> next_velocity{};  // [m/s] of its points on the ground after the step; working memory
  };
  // of moving entities that are members of no solver
  static constexpr int outside = -1;
  static constexpr int insane = -2;  // it belongs to an island, but its numbers have gone bad

  void find_islands(const std::vector<MovingEntity>& moving_entities, const PairSet& set);
  static bool start_member(MovingEntity& moving_entity, double dt) noexcept;
  void solve(int island, std::vector<MovingEntity>& moving_entities, PairSet& set, double dt) noexcept;
  void push_members(int island, std::vector<MovingEntity>& moving_entities, const PairSet& set, double dt) noexcept;
  void finish_member(int moving_entity, std::vector<MovingEntity>& moving_entities) noexcept;
  void count_unsettled(const std::vector<MovingEntity>& moving_entities, double dt, PairSet& set) const noexcept;
  [[nodiscard]] bool is_row(const PairContact& contact) const;
  [[nodiscard]] IslandSolver::Side side(int moving_entity, int object, const Vec3d& velocity) const;

  int sweeps_;
  Islands islands_;
  std::vector<Island> island_;   // by its number; more may be there than islands, for their memory
  std::vector<Member> member_;   // by moving entity
  std::vector<int> in_islands_;  // moving entities, rising
  std::vector<const Entity*> entities_, first_members_;  // of these, and of the islands
};

}  // namespace murosimf::collision
