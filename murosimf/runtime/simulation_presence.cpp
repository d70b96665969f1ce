// Who is there: entities come into the world, leave it and come back, between two steps.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf {

Entity& Simulation::add(std::string name, ModelPtr model, const EntityOptions& options,
                        const std::function<void(Entity&)>& furnish, const std::function<void(Entity&)>& prepare) {
  Entity& entity = world_->add(std::move(name), std::move(model), options);
  try {
    attach_all(entity, furnish);
    if (initialized_) tell_of(entity);
  } catch (...) {
    take_back(entity);
    throw;
  }
  if (initialized_) begin(entity, prepare);
  for (const auto& task : tasks_) task->comes_along = false;
  return entity;
}

/// One that has all its algorithms.
void Simulation::begin(Entity& entity, const std::function<void(Entity&)>& prepare) {
  try {
    check_and_plan();
    keep_start_of(entity);
    start_again(entity, prepare);
  } catch (...) {
    for (const auto& task : tasks_) task->algorithm->entity_taken_back(entity);
    take_back(entity);
    throw;
  }
  entity.set_present(entity.options().present);
  take_over_idle();
  restart_checks();
  record(fmt::format("{}: added", entity.name()));
}

void Simulation::attach_all(Entity& entity, const std::function<void(Entity&)>& furnish) {
  adds_ = true;
  try {
    furnish(entity);
  } catch (...) {
    adds_ = false;
    throw;
  }
  adds_ = false;
}

/// All algorithms that were there take what they need of it; if one throws, none has taken anything.
void Simulation::tell_of(Entity& entity) {
  world_->thaw_columns();
  std::vector<Algorithm*> told;
  try {
    for (const auto& task : tasks_) {
      if (task->comes_along) continue;
      Setup setup(*world_, entity, task->access, task->period);
      murosimf::with_context(full_name(*task), [&] { task->algorithm->entity_added(setup); });
      told.push_back(task->algorithm.get());
    }
  } catch (...) {
    for (Algorithm* algorithm : told) algorithm->entity_taken_back(entity);
    throw;
  }
  world_->freeze_columns();
}

void Simulation::keep_start_of(Entity& entity) {
  keep_columns(entity);
  for (const auto& task : tasks_) {
    if (!task->comes_along) continue;
    keep_new_columns(*task);
    keep_memory(*task);
  }
}

/// Nobody but what came along refers to it.
void Simulation::take_back(Entity& entity) {
  const auto first = std::ranges::stable_partition(tasks_, [](const auto& task) { return !task->comes_along; }).begin();
  std::vector<std::unique_ptr<Task>> gone(std::make_move_iterator(first), std::make_move_iterator(tasks_.end()));
  tasks_.erase(first, tasks_.end());
  for (const auto& task : tasks_) task->access.forget(entity);
  for (const auto& task : gone) drop_columns_of(*task);
  gone.clear();
  world_->take_back_last();
  if (!initialized_) return;
  world_->freeze_columns();
  check_and_plan();
  restart_checks();
}

void Simulation::leave(Entity& entity) {
  initialize();
  if (!entity.present()) throw SetupError(fmt::format("'{}' is not there", entity.name()));
  entity.set_present(false);
  take_over_idle();
  record(fmt::format("{}: left", entity.name()));
}

void Simulation::enter(Entity& entity, const std::function<void(Entity&)>& prepare) {
  initialize();
  if (entity.present()) throw SetupError(fmt::format("'{}' is there already", entity.name()));
  try {
    start_again(entity, prepare);
  } catch (...) {
    entity.set_present(false);
    take_over_idle();
    restart_checks();
    throw;
  }
  take_over_idle();
  restart_checks();
  record(fmt::format("{}: entered", entity.name()));
}

/// What a reset does, for one entity.
void Simulation::start_again(Entity& entity, const std::function<void(Entity&)>& prepare) {
  go_back_to_start(entity);
  entity.set_present(false);
  for (const auto& task : tasks_) {
    if (task->entity == &entity) recall_first(*task);
  }
  if (prepare) prepare(entity);
  entity.set_present(true);
  for (const auto& task : tasks_) {
    murosimf::with_context(full_name(*task), [&] {
      const bool starts = task->entity == &entity || task->comes_along;
      starts ? task->algorithm->initialize() : task->algorithm->entity_entered(entity);
    });
  }
}

}  // namespace murosimf
