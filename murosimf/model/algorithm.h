/// algorithm.h - anything that is executed at a rate and reads and writes properties.
///
/// Motion, contact, sensors, controllers and recorders all look like this to the scheduler. The constructor takes a
/// `Setup&` first and obtains spans from it; that is all the wiring there is (docs/add_an_algorithm.md).
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "murosimf/model/time.h"

namespace murosimf {

class Entity;
class ParallelFor;
class LaneGroup;
class Setup;
class StateArchive;

/// The moment at which an algorithm is executed.
struct Instant {
  Duration now{};     ///< simulated time at the beginning of the step
  Duration period{};  ///< time until this algorithm's next step
  ParallelFor* parallel_for =
      nullptr;  ///< threads that have nothing else to do meanwhile (parallel_for.h); null: there are none
};

/// The parts of a tick, in their order. Algorithms that conflict run by phase, those of one phase in the order in which they
/// were attached.
enum class Phase : std::uint8_t {
  survey,       ///< what all sensors share is worked out
  sense,        ///< sensors see what the last tick left
  control,      ///< controllers read sensors and write targets; pushes
  contact,      ///< where each entity touches the ground, and the forces of it
  interaction,  ///< where entities touch each other
  motion,       ///< levels of detail move their entities
  observe,      ///< recorders read what has come of it
};

class Algorithm {
 public:
  virtual ~Algorithm() = default;

  [[nodiscard]] virtual Phase phase() const noexcept = 0;

  /// Gives the columns that it writes their first values. Called before the first step, and at every reset when all that it
  /// remembers is as its constructor left it; by phase and in the order of attaching.
  virtual void initialize() {}

  /// An entity has been added while it runs: takes those columns of it that its constructor would have taken. `setup` is that of the
  /// new entity. Between two steps. Throws SetupError, and is as before then.
  virtual void entity_added(Setup&) {}
  /// It is taken back: some other algorithm could not do without something. As before the last entity_added().
  virtual void entity_taken_back(const Entity&) noexcept {}
  /// An entity whose columns it writes has come (back) into the world, while it runs: gives these columns their first values.
  /// Between two steps, in place of initialize(), if the algorithm is attached to another entity.
  virtual void entity_entered(const Entity&) {}

  /// An entity has another model of the same objects (Entity::exchange_model), between two steps: works out anew what it has worked
  /// out of the one before, which ends with this call. The entity's level is made anew instead, and does not get this call.
  virtual void model_exchanged(const Entity&) {}

  /// From now on has the random numbers that `seed` would have given to its constructor. Called between two steps, before
  /// initialize() or a state is loaded.
  virtual void reseed(std::uint64_t) {}

  /// Saves or loads what it remembers from step to step besides columns (state_archive.h); nothing, if all is in columns. Called
  /// between two steps.
  virtual void state(StateArchive&) {}

  /// One step. Never throws: numbers that go bad freeze their entity instead.
  virtual void step(const Instant& instant) noexcept = 0;

  /// Whether both may be members of one group that steps them in lanes (lane_group.h); asked before each is planned.
  [[nodiscard]] virtual bool goes_with(const Algorithm&) const { return false; }
  /// A group of these, up to eight of which each goes with this one, which is the first. They outlive it.
  [[nodiscard]] virtual std::unique_ptr<LaneGroup> join(std::span<Algorithm* const> members) const;
};

}  // namespace murosimf
