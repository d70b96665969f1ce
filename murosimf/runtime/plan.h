/// plan.h - which algorithms run when, and which together: the tick, and waves from declared access.
///
/// The tick is the time that all steps of motion have in common. What is done more rarely than these is done in the tick that
/// begins nearest to its instants (rate.h), so that a camera with 30 Hz goes with steps of 1 ms.
///
/// Walk the due algorithms in their order, by phase and then as they were attached; put each into the first wave after every earlier
/// one that it conflicts with. The same for one thread and for many.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "murosimf/world/access.h"
#include "murosimf/world/rate.h"

namespace murosimf {

/// Indices of algorithms that may run in parallel.
using Wave = std::vector<std::size_t>;

/// Waves of the due algorithms, given by index in their order.
[[nodiscard]] std::vector<Wave> make_waves(std::span<const std::size_t> due, std::span<const AccessSet* const> access);

/// What is to be planned of an algorithm.
struct PlannedTask {
  std::string name;  ///< for messages
  const AccessSet* access = nullptr;
  Rate rate;
  bool steps = false;  ///< it makes steps in time, whose length may not vary: motion, and what works on its steps
};

/// The waves of every tick of a simulation.
class Plan {
 public:
  Plan() = default;
  /// In the order of the tasks. `now`: where the simulation is, a multiple of the tick too. Throws SetupError if the periods of all that
  /// steps, or of all if nothing does, and those that are shorter, have no common divisor of at least 10 microseconds.
  explicit Plan(std::span<const PlannedTask> tasks, Duration now = {});

  /// Greatest common divisor of these periods and of the time at which it was planned: one step of the simulation.
  [[nodiscard]] Duration tick() const { return tick_; }

  /// Waves that are due at tick number `n`.
  [[nodiscard]] const std::vector<Wave>& due(std::int64_t n);
  /// The waves of a tick in which all algorithms are due.
  [[nodiscard]] std::vector<Wave> all() const;

 private:
  /// Algorithms with the same rate are due together.
  struct Group {
    Rate rate;
    std::int64_t ticks = 0;  ///< of its period, if it is due at whole multiples of that; else 0
    std::vector<std::size_t> algorithms;
  };
  [[nodiscard]] bool is_due(const Group& group, std::int64_t n) const;

  Duration tick_ = std::chrono::milliseconds(1);
  std::vector<const AccessSet*> access_;
  std::vector<Group> groups_;
  std::map<std::uint64_t, std::vector<Wave>> waves_;  // by which groups are due, one bit each
};

}  // namespace murosimf
