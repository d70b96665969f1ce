#include "murosimf/runtime/simulation_lanes.h"

#include <algorithm>

#include "murosimf/math/floating_point.h"
#include "murosimf/model/error.h"
#include "murosimf/world/foreign_code.h"

namespace murosimf {

SimulationLanes::SimulationLanes(std::vector<Simulation*> simulations) : simulations_(std::move(simulations)) {
  const auto names = [](const Simulation& simulation) {
    std::vector<std::string> result;
    for (const auto& task : simulation.tasks_) result.push_back(full_name(*task));
    return result;
  };
  for (Simulation* simulation : simulations_) {
    simulation->initialize();
    if (names(*simulation) != names(*simulations_.front())) {
      throw SetupError("simulations that are to step side by side do not have the same algorithms");
    }
  }
  join();
}

bool SimulationLanes::can_hold(const Simulation& simulation) {
  const auto is_foreign = [](const auto& task) { return ForeignCode::of(*task->algorithm) != nullptr; };
  return simulation.timed_calls_.empty() && std::ranges::none_of(simulation.tasks_, is_foreign);
}

/// An entity that makes steps of its own length is due when those of other worlds are not.
void SimulationLanes::join() {
  groups_.clear();
  joined_.assign(simulations_.size(), {});
  for (std::size_t s = 0; s < simulations_.size(); ++s) {
    for (const auto& task : simulations_[s]->tasks_) joined_[s].push_back(task->algorithm.get());
  }
  for (std::size_t number = 0; number < joined_.front().size(); ++number) {
    std::vector<Algorithm*> members;
    bool together = simulations_.size() > 1;
    for (const Simulation* simulation : simulations_) {
      const Task& task = simulation->tasks_[number];
      members.push_back(task.algorithm.get());
      together = together && !task.step_ratio && !ForeignCode::of(*task.algorithm) &&
                 members.front()->goes_with(*members.back()) && members.back()->goes_with(*members.front());
    }
    groups_.push_back(together ? members.front()->join(members) : nullptr);
  }
}

std::size_t SimulationLanes::algorithms_in_lanes() const {
  return static_cast<std::size_t>(std::ranges::count_if(groups_, [](const auto& group) { return group != nullptr; }));
}

bool SimulationLanes::is_as_joined(int lane) const {
  const auto same = [](const auto& task, const Algorithm* joined) { return task->algorithm.get() == joined; };
  return std::ranges::equal(member(lane).tasks_, joined_[static_cast<std::size_t>(lane)], same);
}

void SimulationLanes::step(LaneMask due, int steps) {
  const StandardFloatingPoint modes;
  LaneMask together = 0;
  for_lanes(due, [&](int lane) {
    if (is_as_joined(lane) && can_hold(member(lane))) together |= lane_bit(lane);
  });
  for_lanes(due & ~together, [&](int lane) {
    for (int i = 0; i < steps; ++i) member(lane).step();
  });
  if (together == 0) return;
  for (const auto& group : groups_) {
    if (group) group->begin_at(times_.data());  // here, since this may have been moved
  }
  known_.clear();
  own_.fill(nullptr);
  for (int i = 0; i < steps; ++i) tick(together);
  for_lanes(together, [&](int lane) { member(lane).scheduler_.restart_checks(); });
}

void SimulationLanes::tick(LaneMask lanes) {
  for_lanes(lanes, [&](int lane) {
    Simulation& simulation = member(lane);
    simulation.registry_.take_over_frozen();
    times_[static_cast<std::size_t>(lane)] = simulation.now();
    waves_[static_cast<std::size_t>(lane)] = &due_waves(lane);
  });
  for (LaneMask left = lanes; left != 0;) {
    const Waves* waves = nullptr;
    LaneMask alike = 0;
    for_lanes(left, [&](int lane) {
      if (!waves) waves = waves_[static_cast<std::size_t>(lane)];
      if (waves_[static_cast<std::size_t>(lane)] == waves) alike |= lane_bit(lane);
    });
    run(*waves, alike);
    left &= ~alike;
  }
  for_lanes(lanes, [&](int lane) {
    Simulation& simulation = member(lane);
    simulation.scheduler_.advance();
    simulation.registry_.take_over_frozen();
  });
}

/// Equal ones are the same ones.
auto SimulationLanes::due_waves(int lane) -> const Waves& {
  const auto i = static_cast<std::size_t>(lane);
  const Waves& own = member(lane).scheduler_.due_waves();
  if (own_[i] == &own) return *waves_[i];  // as in the tick before
  own_[i] = &own;
  const auto known = std::ranges::find_if(known_, [&](const Waves* one) { return *one == own; });
  if (known != known_.end()) return **known;
  known_.push_back(&own);
  return own;
}

void SimulationLanes::run(const Waves& waves, LaneMask lanes) noexcept {
  for (const Wave& wave : waves) {
    for (const std::size_t number : wave) execute(number, lanes);
  }
}

void SimulationLanes::execute(std::size_t number, LaneMask lanes) noexcept {
  LaneGroup* const group = groups_[number].get();
  LaneMask awake = 0;
  Duration period{};
  for_lanes(lanes, [&](int lane) {
    Task& task = member(lane).tasks_[number];
    if (!group && (task.step_ratio || ForeignCode::of(*task.algorithm))) return member(lane).scheduler_.execute(task);
    if (task.idle) return;
    ++task.calls;
    if (!group) {
      const KeptFloatingPoint modes;  // a controller may be the program's
      return task.algorithm->step({times_[static_cast<std::size_t>(lane)], task.period});
    }
    period = task.period;
    awake |= lane_bit(lane);
  });
  if (awake != 0) group->step(awake, {{}, period});
}

}  // namespace murosimf
