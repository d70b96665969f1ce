/// plan.h - which algorithms run together: waves from declared access.
///
/// Walk the due algorithms in their order, by phase and then as they were attached; put each into the first wave after every earlier
/// one that it conflicts with. The same for one thread and for many.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "murosimf/model/access.h"
#include "murosimf/model/time.h"

namespace murosimf {

/// Indices of algorithms that may run in parallel.
using Wave = std::vector<std::size_t>;

/// Waves of the due algorithms, given by index in their order.
[[nodiscard]] std::vector<Wave> make_waves(std::span<const std::size_t> due, std::span<const AccessSet* const> access);

/// The waves of every tick of a simulation.
class Plan {
 public:
  Plan() = default;
  /// One access set and one period per algorithm, in their order. Throws SetupError if the periods have no
  /// common tick of at least 10 microseconds; `names` are for the message. `now`: where the simulation is, a multiple of the tick too.
  Plan(std::vector<const AccessSet*> access, std::span<const Duration> periods, std::span<const std::string> names,
       Duration now = {});

  /// Greatest common divisor of all periods, and of the time at which it was planned: one step of the simulation.
  [[nodiscard]] Duration tick() const { return tick_; }

  /// Waves that are due at tick number `n`. An algorithm with period p is due at 0, p, 2p, ...
  [[nodiscard]] const std::vector<Wave>& due(std::int64_t n);

 private:
  /// Algorithms with the same period are due together.
  struct Group {
    std::int64_t ticks = 1;
    std::vector<std::size_t> algorithms;
  };

  Duration tick_ = std::chrono::milliseconds(1);
  std::vector<const AccessSet*> access_;
  std::vector<Group> groups_;
  std::map<std::uint64_t, std::vector<Wave>> waves_;  // by which groups are due, one bit each
};

}  // namespace murosimf
