/// task.h - an attached algorithm: when it is due, what it has declared, how it began, what it has cost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/world/access.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/motion_level.h"
#include "murosimf/world/rate.h"
#include "murosimf/world/setup.h"

namespace murosimf {

struct Task {
  std::string name;
  const Entity* entity = nullptr;
  Rate rate{usual_step_rate};
  Duration period{};  ///< of `rate`
  std::unique_ptr<Algorithm> algorithm;
  MotionLevel* level = nullptr;  ///< the algorithm, if it is one
  AccessSet access;
  bool comes_along = false;             ///< with the entity that is being added
  const double* step_ratio = nullptr;   ///< properties::step_ratio, if the entity makes steps of its own length
  bool idle = false;                    ///< of the entity, copied between ticks so that it cannot change during one
  std::vector<std::byte> first_memory;  ///< the algorithm's own state before it has first been initialized

  std::int64_t calls = 0;
  std::int64_t timed_calls = 0;  ///< of `calls`, those that `time` stands for
  Duration time{};               ///< wall time
};

/// Without its algorithm. Throws SetupError for an impossible rate.
[[nodiscard]] std::unique_ptr<Task> new_task(std::string name, const Entity& entity, const Rate& rate);

/// "walk_engine of blue1"
[[nodiscard]] std::string full_name(const Task& task);

/// Motion, and what works on its steps: these may have a length of their own.
[[nodiscard]] bool makes_steps(Phase phase) noexcept;
/// Has a task that makes steps read the length that its entity has chosen for them. `setup` is the one that its algorithm was made with.
void follow_step_multiple(Task& task, Setup& setup);

/// Keeps what the algorithm remembers, and has it remember just that again.
void keep_memory(Task& task);
void recall_first(Task& task);

}  // namespace murosimf
