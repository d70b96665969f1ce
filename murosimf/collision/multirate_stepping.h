/// multirate_stepping.h - algorithm: entities that are alone make steps of their own length, longer than those of the scene.
///
/// Paper 3.3 gives every algorithm a rate of its own. Contact with the ground and motion of one entity solve one system (contact.h), so
/// these have one; between entities a contact needs both sides at every instant, or momentum is lost. Therefore an entity with
/// EntityOptions::step_multiple = m makes steps of m times the scene's length while no entity is near, and otherwise those of the scene. That is
/// decided whenever a long step is due: near are entities that might touch it before the next one,
///
///     |r_i - r_j| < R_i + R_j + margin + (|v_i| + |v_j|) m T
///
/// with R the reach of an entity in any posture and T the length of the scene's steps. Its state is then ahead of the time by up to
/// m T, as that of every entity is by T.
///
/// Assumes: no entity gains more than margin / (m T), 10 m/s with 5 ms, within one long step; what comes faster is noticed at its end.
#pragma once

#include <span>
#include <vector>

#include "murosimf/geometry/sweep_and_prune.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::collision {

class MultirateStepping final : public Algorithm {
 public:
  /// Of the world, at the rate of the scene's steps. Writes `step_ratio` of those of `moving_entities` that have own steps.
  MultirateStepping(Setup& setup, const std::vector<Entity*>& moving_entities);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::survey; }
  void initialize() override;
  void entity_added(Setup& setup) override;
  void entity_taken_back(const Entity& entity) noexcept override;
  void entity_entered(const Entity& entity) override;
  void step(const Instant& instant) noexcept override;

 private:
  struct Mover {
    const Entity* entity;
    double reach;  ///< [m] around the base
    std::span<const Vec3d> r, v;
    std::span<double> step_ratio;  ///< empty: its steps are the scene's
  };
  [[nodiscard]] static Mover mover(Setup setup);
  /// With steps of the scene, until it is decided.
  static void start(const Mover& mover);
  [[nodiscard]] bool any_decides(const Instant& instant) const noexcept;
  void decide(const Instant& instant) noexcept;

  std::vector<Mover> movers_;
  std::vector<geometry::BoundingSphere> near_;  // of each mover; working memory
  std::vector<bool> has_company_;
  geometry::SweepAndPrune sweep_;
};

}  // namespace murosimf::collision
