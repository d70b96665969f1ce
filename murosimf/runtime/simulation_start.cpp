// How a simulation gets to the time 0: the first time, and again. Columns and algorithms go back to what they were before the first
// start, and then do what they did there.
#include "murosimf/math/floating_point.h"
#include "murosimf/model/error.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf {

void Simulation::initialize() {
  if (initialized_) return;
  const StandardFloatingPoint modes;
  check_and_plan();
  world_->freeze_columns();
  keep_start();
  start();
}

void Simulation::start() {
  const StandardFloatingPoint modes;
  for (const auto& call : before_start_) call();
  modes.again();
  for (const auto& task : tasks_) {
    const KeptFloatingPoint of_others;
    murosimf::with_context(full_name(*task), [&] { task->algorithm->initialize(); });
  }
  initialized_ = true;
  take_over_idle();
  for (const auto& call : after_start_) call();
  modes.again();
  restart_checks();
  poses_.publish(*world_, now_, ticks_);
}

void Simulation::reset() {
  if (!initialized_) return initialize();
  go_back_to_start();
  start();
}

/// What start() begins with.
void Simulation::keep_start() {
  world_->for_all([](Entity& entity) { keep_columns(entity); });
  for (const auto& task : tasks_) keep_memory(*task);
  events_before_start_ = events_.size();
}

void Simulation::keep_columns(Entity& entity) {
  for (const auto& [name, column] : entity.columns()) column->keep();
}

void Simulation::keep_memory(Task& task) {
  task.first_memory.clear();
  StateArchive archive(task.first_memory);
  task.algorithm->state(archive);
}

void Simulation::recall_first(Task& task) {
  StateArchive archive(std::span<const std::byte>(task.first_memory));
  task.algorithm->state(archive);
}

/// Of its columns, all that start() does not give their first values.
void Simulation::go_back_to_start(Entity& entity) {
  entity.unfreeze();
  entity.set_present(entity.options().present);
  for (const auto& [name, column] : entity.columns()) {
    if (column->info().scope != Scope::wiring) column->go_back();
  }
}

void Simulation::go_back_to_start() {
  world_->for_all([](Entity& entity) { go_back_to_start(entity); });
  for (const auto& task : tasks_) {
    recall_first(*task);
    task->calls = task->timed_calls = 0;
    task->time = {};
  }
  retired_.clear();
  timed_calls_.clear();
  warnings_.clear();
  queue_.forget_history();
  events_.resize(events_before_start_);
  scheduled_done_ = frozen_reported_ = 0;
  now_ = {};
  align_plan();
}

void Simulation::reseed(std::uint64_t seed) {
  for (const auto& task : tasks_) task->algorithm->reseed(seed);
}

}  // namespace murosimf
