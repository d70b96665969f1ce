/// algorithm.h - algorithms: executed at a rate, they read and write properties.
///
/// Motion, contact, sensors, controllers and recorders all look like this to the scheduler. The constructor takes a
/// `Setup&` first and obtains spans from it; that is all the wiring there is (docs/add_an_algorithm.md).
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "murosimf/world/time.h"

namespace murosimf {

class Entity;
class ParallelFor;
class LaneGroup;
class Setup;
class StateArchive;

/// The moment at which an algorithm is executed.
struct Instant {
  Duration now{};                       ///< simulated time at the beginning of the step
  Duration period{};                    ///< time until this algorithm's next step
  ParallelFor* parallel_for = nullptr;  ///< threads that are idle meanwhile (parallel_for.h); null: none
};

/// The parts of a tick, in their order. Algorithms that conflict run by phase, those of one phase in the order in which they
/// were attached.
enum class Phase : std::uint8_t {
  survey,       ///< common computations of all sensors
  sense,        ///< sensors read the state after the last tick
  control,      ///< controllers read sensors and write targets; pushes
  contact,      ///< contacts of each entity with the ground, and their forces
  interaction,  ///< contacts between entities
  motion,       ///< levels of detail move their entities
  observe,      ///< recorders read the result
};

class Algorithm {
 public:
  virtual ~Algorithm() = default;

  [[nodiscard]] virtual Phase phase() const noexcept = 0;

  /// Sets the first values of the columns that it writes. Called before the first step, and at every reset, when all its memory
  /// is as its constructor left it; by phase and in the order of attaching.
  virtual void initialize() {}

  /// An entity has been added to a running simulation: takes those of its columns that the constructor would have taken. `setup` is
  /// that of the new entity. Between two steps. Throws SetupError, and is unchanged then.
  virtual void entity_added(Setup&) {}
  /// The entity is removed again because another algorithm has rejected it. Restores the state before the last entity_added().
  virtual void entity_taken_back(const Entity&) noexcept {}
  /// An entity whose columns it writes enters the world (again) in a running simulation: sets the first values of these columns.
  /// Between two steps, in place of initialize(), if the algorithm is attached to another entity.
  virtual void entity_entered(const Entity&) {}

  /// An entity has another model of the same objects (Entity::exchange_model), between two steps: recomputes all data derived from the
  /// preceding one, which ends with this call. The entity's level is created anew instead, and does not get this call.
  virtual void model_exchanged(const Entity&) {}

  /// Switches to the random numbers that `seed` would have given to its constructor. Called between two steps, before
  /// initialize() or before a state is loaded.
  virtual void reseed(std::uint64_t) {}

  /// Saves or loads its memory from step to step besides columns (state_archive.h); nothing, if all is in columns. Called
  /// between two steps.
  virtual void state(StateArchive&) {}

  /// Executes one step. Never throws: an entity whose numbers are not sane is frozen instead.
  virtual void step(const Instant& instant) noexcept = 0;

  /// Whether both may be members of one group that steps them in lanes (lane_group.h); asked before each is planned.
  [[nodiscard]] virtual bool goes_with(const Algorithm&) const { return false; }
  /// A group of these, up to eight of which each goes with this one, which is the first. They outlive it.
  [[nodiscard]] virtual std::unique_ptr<LaneGroup> join(std::span<Algorithm* const> members) const;
};

}  // namespace murosimf
