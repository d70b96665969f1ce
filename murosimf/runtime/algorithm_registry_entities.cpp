// Entities come into the world, leave it and come back, with their algorithms.
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/runtime/algorithm_registry.h"
#include "murosimf/runtime/start_state.h"

namespace murosimf {

Entity& AlgorithmRegistry::add(std::string name, ModelPtr model, const EntityOptions& options,
                               const std::function<void(Entity&)>& furnish,
                               const std::function<void(Entity&)>& prepare) {
  Entity& entity = world_.add(std::move(name), std::move(model), options);
  try {
    attach_all(entity, furnish);
    if (started_) tell_of(entity);
  } catch (...) {
    take_back(entity);
    throw;
  }
  if (started_) begin(entity, prepare);
  for (const auto& task : tasks_) task->comes_along = false;
  return entity;
}

/// One that has all its algorithms.
void AlgorithmRegistry::begin(Entity& entity, const std::function<void(Entity&)>& prepare) {
  try {
    scheduler_.plan();
    keep_start_of(entity);
    start_again(entity, prepare);
  } catch (...) {
    for (const auto& task : tasks_) task->algorithm->entity_taken_back(entity);
    take_back(entity);
    throw;
  }
  entity.set_present(entity.options().present);
  tasks_.take_over_idle();
  scheduler_.restart_checks();
  log_.record(scheduler_.now(), fmt::format("{}: added", entity.name()));
}

void AlgorithmRegistry::attach_all(Entity& entity, const std::function<void(Entity&)>& furnish) {
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
void AlgorithmRegistry::tell_of(Entity& entity) {
  world_.thaw_columns();
  std::vector<Algorithm*> told;
  try {
    for (const auto& task : tasks_) {
      if (task->comes_along) continue;
      Setup setup(world_, entity, task->access, task->period);
      murosimf::with_context(full_name(*task), [&] { task->algorithm->entity_added(setup); });
      told.push_back(task->algorithm.get());
    }
  } catch (...) {
    for (Algorithm* algorithm : told) algorithm->entity_taken_back(entity);
    throw;
  }
  world_.freeze_columns();
}

void AlgorithmRegistry::keep_start_of(Entity& entity) {
  keep_columns(entity);
  for (const auto& task : tasks_) {
    if (!task->comes_along) continue;
    keep_new_columns(*task);
    keep_memory(*task);
  }
}

/// Only what came along refers to it.
void AlgorithmRegistry::take_back(Entity& entity) {
  MUROSIMF_ASSERT(world_.entities().back().get() == &entity);
  std::vector<std::unique_ptr<Task>> gone = tasks_.take_those_that_come_along();
  for (const auto& task : tasks_) task->access.forget(entity);
  for (const auto& task : gone) drop_columns_of(*task);
  gone.clear();
  world_.take_back_last();
  if (!started_) return;
  world_.freeze_columns();
  scheduler_.plan();
  scheduler_.restart_checks();
}

void AlgorithmRegistry::leave(Entity& entity) {
  if (!entity.present()) throw SetupError(fmt::format("'{}' is not there", entity.name()));
  entity.set_present(false);
  tasks_.take_over_idle();
  log_.record(scheduler_.now(), fmt::format("{}: left", entity.name()));
}

void AlgorithmRegistry::enter(Entity& entity, const std::function<void(Entity&)>& prepare) {
  if (entity.present()) throw SetupError(fmt::format("'{}' is there already", entity.name()));
  try {
    start_again(entity, prepare);
  } catch (...) {
    entity.set_present(false);
    tasks_.take_over_idle();
    scheduler_.restart_checks();
    throw;
  }
  tasks_.take_over_idle();
  scheduler_.restart_checks();
  log_.record(scheduler_.now(), fmt::format("{}: entered", entity.name()));
}

/// What a reset does, for one entity.
void AlgorithmRegistry::start_again(Entity& entity, const std::function<void(Entity&)>& prepare) {
  murosimf::go_back_to_start(entity);
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
