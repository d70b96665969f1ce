/// simulation_lanes.h - up to eight simulations that were built alike, stepped side by side: their equal algorithms in lanes.
///
/// Each makes the steps that Simulation::step() makes of it, bit for bit, from its own simulated time on. Algorithms of the same number
/// step together if they go together (Algorithm::goes_with); all others step alone. Meanwhile no poses are published and no commands are
/// carried out. A simulation that has calls to make at given times, or another algorithm than in the beginning, steps by itself.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "murosimf/runtime/simulation.h"
#include "murosimf/world/lane_group.h"

namespace murosimf {

class SimulationLanes {
 public:
  /// One to eight, which outlive it. Initializes them. Throws SetupError if they do not have the same algorithms.
  explicit SimulationLanes(std::vector<Simulation*> simulations);

  /// Whether a simulation that has been initialized may take part: all that it does follows from its state, with nothing planned for later.
  [[nodiscard]] static bool can_hold(const Simulation& simulation);

  /// Makes so many steps of those in `due`, by their numbers.
  void step(LaneMask due, int steps);

  /// How many algorithms of one simulation step in lanes.
  [[nodiscard]] std::size_t algorithms_in_lanes() const;

 private:
  using Waves = std::vector<Wave>;

  [[nodiscard]] Simulation& member(int lane) const { return *simulations_[static_cast<std::size_t>(lane)]; }
  void join();
  [[nodiscard]] bool is_as_joined(int lane) const;
  void tick(LaneMask lanes);
  [[nodiscard]] const Waves& due_waves(int lane);
  void run(const Waves& waves, LaneMask lanes) noexcept;
  void execute(std::size_t number, LaneMask lanes) noexcept;

  std::vector<Simulation*> simulations_;
  std::vector<std::vector<const Algorithm*>> joined_;  // by simulation: its algorithms, as they were then
  std::vector<std::unique_ptr<LaneGroup>> groups_;     // by algorithm; null: it steps alone
  std::array<Duration, Pack8::lanes> times_{};         // where the members are
  std::array<const Waves*, Pack8::lanes> waves_{},
      own_{};                        // due in this tick: those of the first that has such ones; its own
  std::vector<const Waves*> known_;  // in the present call: of which no two are equal
};

}  // namespace murosimf
