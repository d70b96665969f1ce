/// pacer.h - control of when a step of a simulation may begin: none, a clock (clock.h), or another program (lock_step.h).
#pragma once

#include <functional>

#include "murosimf/world/time.h"

namespace murosimf {

/// Whether to end early. Called often, by the thread that runs the simulation.
using StopRequest = std::function<bool()>;

/// As it stands: as fast as possible. All are called by the thread that runs the simulation, and return soon once `stop` says true.
class Pacer {
 public:
  virtual ~Pacer() = default;
  /// A run begins or goes on at the simulated time `now`.
  virtual void start(Duration /*now*/) {}
  /// Returns when the step from `now` on may begin.
  virtual void before_step(Duration /*now*/, const StopRequest& /*stop*/) {}
  /// A step has ended at `now`; returns when observers may see its results.
  virtual void after_step(Duration /*now*/, const StopRequest& /*stop*/) {}
};

}  // namespace murosimf
