#include "murosimf/runtime/task.h"

#include <span>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {

std::unique_ptr<Task> new_task(std::string name, const Entity& entity, const Rate& rate) {
  if (!(rate.hz >= slowest_rate && rate.hz <= fastest_rate)) {
    throw SetupError(
        fmt::format("the rate of '{}', {} Hz, is not between {} and {} Hz", name, rate.hz, slowest_rate, fastest_rate));
  }
  if (!(rate.phase >= 0 && rate.phase < 1)) {
    throw SetupError(fmt::format("the phase of '{}', {}, is not from 0 to below 1", name, rate.phase));
  }
  auto task = std::make_unique<Task>();
  task->name = std::move(name);
  task->entity = &entity;
  task->rate = rate;
  task->period = rate.period();
  MUROSIMF_ASSERT(task->period > Duration{});
  return task;
}

std::string full_name(const Task& task) { return fmt::format("{} of {}", task.name, task.entity->name()); }

bool makes_steps(Phase phase) noexcept {
  return phase == Phase::contact || phase == Phase::interaction || phase == Phase::motion;
}

void follow_step_multiple(Task& task, Setup& setup) {
  MUROSIMF_ASSERT(task.algorithm && &setup.entity() == task.entity);
  const int step_multiple = setup.entity().options().step_multiple;
  if (step_multiple > 1 && makes_steps(task.algorithm->phase())) {
    task.step_ratio = setup.input(properties::step_ratio, step_multiple).data();
  }
}

void keep_memory(Task& task) {
  task.first_memory.clear();
  StateArchive archive(task.first_memory);
  task.algorithm->state(archive);
}

void recall_first(Task& task) {
  StateArchive archive(std::span<const std::byte>(task.first_memory));
  task.algorithm->state(archive);
  MUROSIMF_ASSERT(archive.left() == 0 && "state() says the same when it saves and when it loads");
}

}  // namespace murosimf
