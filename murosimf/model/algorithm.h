/// algorithm.h - anything that is executed at a rate and reads and writes properties.
///
/// Motion, contact, sensors, controllers and recorders all look like this to the scheduler. The constructor takes a
/// `Setup&` first and obtains spans from it; that is all the wiring there is (docs/add_an_algorithm.md).
#pragma once

#include "murosimf/model/time.h"

namespace murosimf {

/// The moment at which an algorithm is executed.
struct Instant {
  Duration now{};     ///< simulated time at the beginning of the step
  Duration period{};  ///< time until this algorithm's next step
};

class Algorithm {
 public:
  virtual ~Algorithm() = default;

  /// Gives the columns that it writes their first values. Called once, in the order of attaching, before any step.
  virtual void initialize() {}

  /// One step. Never throws: numbers that go bad freeze their entity instead.
  virtual void step(const Instant& instant) noexcept = 0;
};

}  // namespace murosimf
