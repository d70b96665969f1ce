/// algorithm.h - anything that is executed at a rate and reads and writes properties.
///
/// Motion, contact, sensors, controllers and recorders all look like this to the scheduler. The constructor takes a
/// `Setup&` first and obtains spans from it; that is all the wiring there is (docs/add_an_algorithm.md).
#pragma once

#include <cstdint>

#include "murosimf/model/time.h"

namespace murosimf {

class StateArchive;

/// The moment at which an algorithm is executed.
struct Instant {
  Duration now{};     ///< simulated time at the beginning of the step
  Duration period{};  ///< time until this algorithm's next step
};

/// The parts of a tick, in their order. Algorithms that conflict run by phase, those of one phase in the order in which they
/// were attached.
enum class Phase : std::uint8_t {
  sense,    ///< sensors see what the last tick left
  control,  ///< controllers read sensors and write targets; pushes
  contact,  ///< what touches what, and the forces of it
  motion,   ///< levels of detail move their entities
  observe,  ///< recorders read what has come of it
};

class Algorithm {
 public:
  virtual ~Algorithm() = default;

  [[nodiscard]] virtual Phase phase() const noexcept = 0;

  /// Gives the columns that it writes their first values. Called before the first step, and at every reset when all that it
  /// remembers is as its constructor left it; by phase and in the order of attaching.
  virtual void initialize() {}

  /// From now on has the random numbers that `seed` would have given to its constructor. Called between two steps, before
  /// initialize() or a state is loaded.
  virtual void reseed(std::uint64_t) {}

  /// Saves or loads what it remembers from step to step besides columns (state_archive.h); nothing, if all is in columns. Called
  /// between two steps.
  virtual void state(StateArchive&) {}

  /// One step. Never throws: numbers that go bad freeze their entity instead.
  virtual void step(const Instant& instant) noexcept = 0;
};

}  // namespace murosimf
