/// push.h - algorithm: pushes of one entity's bodies for a while, with a force at their center of mass.
///
/// Adds to `applied_force` in every step that a push overlaps, by the share of the step that it does, so that its impulse
/// is exact; force and moment keep their direction in the world while the body turns. Values that users set there are kept.
#pragma once

#include <span>
#include <vector>

#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

struct TimedPush {
  int object = 0;  ///< a body of the model
  Vec3d force;     ///< [N] world
  Vec3d moment;    ///< [N m] world
  Duration begin{}, end{};
  void state(StateArchive& archive) { archive(object, force, moment, begin, end); }
};

class Push final : public Algorithm {
 public:
  /// Attach it before the contact with the ground, at the same rate.
  Push(Setup& setup, std::vector<TimedPush> pushes);

  /// Adds a push, between two steps; a reset removes it.
  void add(const TimedPush& push);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  void state(StateArchive& archive) override;
  void model_exchanged(const Entity& entity) override;

 private:
  struct Pushed {
    int object = 0;
    Vec3d center;     // [m] of its mass, own axes
    Wrenchd own;      // set by others
    Wrenchd written;  // own and pushes
    void state(StateArchive& archive) { archive(object, center, own, written); }
  };
  void take_up(int object);
  [[nodiscard]] Wrenchd sum_for(const Pushed& pushed, const Instant& instant) const noexcept;

  const Entity& entity_;
  std::vector<TimedPush> pushes_;  // those that are not over, of added ones
  std::vector<Pushed> pushed_;
  std::span<const Mat3d> R_;
  std::span<Wrenchd> applied_force_;
};

}  // namespace murosimf::dynamics
