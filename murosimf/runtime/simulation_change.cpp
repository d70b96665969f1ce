// Who takes part in a simulation: algorithms come, go and are exchanged, before the first step and between any two.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/properties.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf {

Algorithm& Simulation::attach(std::string name, Entity& entity, const Rate& rate, const Maker<Algorithm>& make) {
  auto task = new_task(std::move(name), entity, rate);
  construct(*task, entity, make);
  const Task& added = *task;
  task->comes_along = adds_;
  add_in_order(std::move(task));  // last: a constructor that throws leaves nothing behind
  if (initialized_ && !adds_) start_late(added);
  if (added.level) entity.level = added.name;
  return *added.algorithm;
}

void Simulation::construct(Task& task, Entity& entity, const Maker<Algorithm>& make) {
  world_->thaw_columns();
  try {
    Setup setup(*world_, entity, task.access, task.period);
    task.algorithm = make(setup);
    follow_step_multiple(task, setup);
    task.level = dynamic_cast<MotionLevel*>(task.algorithm.get());
    if (task.level && task_of_level(entity) != tasks_.end()) {
      throw SetupError(
          fmt::format("'{}' cannot move '{}', which another level moves already", task.name, entity.name()));
    }
  } catch (...) {
    if (initialized_) {
      drop_columns_of(task);
      world_->freeze_columns();
    }
    throw;
  }
  if (initialized_) world_->freeze_columns();
}

/// What initialize() does for all, for one that came later.
void Simulation::start_late(const Task& added) {
  const auto task =
      std::find_if(tasks_.begin(), tasks_.end(), [&](const auto& other) { return other.get() == &added; });
  try {
    check_and_plan();
    keep_new_columns(added);
    keep_memory(**task);
    murosimf::with_context(full_name(added), [&] { (*task)->algorithm->initialize(); });
  } catch (...) {
    const std::unique_ptr<Task> refused = std::move(*task);
    tasks_.erase(task);
    drop_columns_of(*refused);
    check_and_plan();
    restart_checks();
    throw;
  }
  restart_checks();
}

/// Those that only this task uses.
void Simulation::keep_new_columns(const Task& task) {
  for (const Access& access : task.access.all()) {
    const auto uses = [&](const auto& other) { return other.get() != &task && other->access.touches(access.column); };
    if (std::none_of(tasks_.begin(), tasks_.end(), uses)) access.entity->find(access.column->info().name)->keep();
  }
}

void Simulation::detach(const Algorithm& algorithm) {
  const auto place =
      std::find_if(tasks_.begin(), tasks_.end(), [&](const auto& task) { return task->algorithm.get() == &algorithm; });
  if (place == tasks_.end()) throw SetupError("an algorithm is detached that is not attached");
  if ((*place)->level) {
    throw SetupError(
        fmt::format("'{}' moves '{}': exchange it for another level", (*place)->name, (*place)->entity->name()));
  }
  const auto number = place - tasks_.begin();
  std::unique_ptr<Task> task = std::move(*place);
  tasks_.erase(place);
  try {
    if (initialized_) check_and_plan();
  } catch (const SetupError& error) {
    tasks_.insert(tasks_.begin() + number, std::move(task));
    check_and_plan();
    throw SetupError(fmt::format("'{}' stays: {}", full_name(*tasks_[static_cast<std::size_t>(number)]), error.what()));
  }
  restart_columns_of(*task);
  drop_columns_of(*task);
  if (initialized_) restart_checks();
  task->algorithm.reset();
  retired_.push_back(std::move(task));
}

MotionLevel& Simulation::exchange(std::string name, Entity& entity, const Maker<MotionLevel>& make, LevelStart start) {
  if (!entity.present()) start = LevelStart::anew;  // it begins when it enters
  const auto present = task_of_level(entity);
  if (present == tasks_.end()) {
    throw SetupError(fmt::format("'{}' has no level that could be exchanged", entity.name()));
  }
  auto next = new_task(name, entity, (*present)->rate);
  try {
    if (entity.frozen() && start == LevelStart::in_motion)
      throw SetupError(fmt::format("it was frozen ({})", *entity.frozen_reason()));
    construct_level(*next, entity, make, start);
    put_in_place_of(*present, next, start);
  } catch (const SetupError& error) {
    drop_columns_of(*next);
    if (initialized_) restart_checks();
    throw SetupError(
        fmt::format("'{}' stays at {}: no {}: {}", entity.name(), (*present)->name, next->name, error.what()));
  }
  // `next` is now what was there before
  restart_columns_of(*next);
  drop_columns_of(*next);
  if (initialized_) restart_checks();
  entity.level = name;
  if (name != next->name) record(fmt::format("{}: {} -> {}", entity.name(), next->name, name));
  next->algorithm.reset();
  retired_.push_back(std::move(next));
  return *(*present)->level;
}

void Simulation::exchange_model(Entity& entity, ModelPtr model, const Maker<MotionLevel>& level, LevelStart start) {
  const ModelPtr before = entity.model_ptr();  // algorithms point into it until they have been told
  const bool moves = initialized_ && entity.present() && start == LevelStart::in_motion;
  const Vec3d v = moves ? entity.base().get(properties::linear_velocity) : Vec3d{};
  const Vec3d w = moves ? entity.base().get(properties::angular_velocity) : Vec3d{};
  entity.exchange_model(std::move(model));
  try {
    exchange(entity.level, entity, level, start);
  } catch (...) {
    entity.exchange_model(before);
    throw;
  }
  if (moves) {  // levels hand momentum over, and the mass is another one
    entity.base().set(properties::linear_velocity, v);
    entity.base().set(properties::angular_velocity, w);
  }
  for (const auto& task : tasks_) {
    if (!task->level || task->entity != &entity) task->algorithm->model_exchanged(entity);
  }
}

/// Leaves `task` without algorithm if that refuses.
void Simulation::construct_level(Task& task, Entity& entity, const Maker<MotionLevel>& make, LevelStart start) {
  world_->thaw_columns();
  Setup setup(*world_, entity, task.access, task.period);
  try {
    auto level = make(setup);
    task.level = level.get();
    task.algorithm = std::move(level);
    follow_step_multiple(task, setup);
  } catch (const SetupError&) {
    if (initialized_) world_->freeze_columns();
    throw;
  }
  if (!initialized_) return;
  world_->freeze_columns();
  keep_new_columns(task);
  keep_memory(task);
  if (start == LevelStart::anew) return;
  if (const std::string why = task.level->refusal(); !why.empty()) throw SetupError(why);
}

/// Swaps the two, and has the motion handed over; on an error everything is as before.
void Simulation::put_in_place_of(std::unique_ptr<Task>& present, std::unique_ptr<Task>& next, LevelStart start) {
  std::swap(present, next);
  if (!initialized_) return;
  std::optional<Momentum> momentum;
  try {
    check_and_plan();
    momentum = next->level->hand_over();
    start == LevelStart::anew ? present->level->initialize() : present->level->take_over(*momentum);
  } catch (const SetupError&) {
    std::swap(present, next);
    check_and_plan();
    if (momentum) present->level->take_over(*momentum);
    throw;
  }
}

/// Columns that only this task has used.
void Simulation::drop_columns_of(const Task& task) {
  for (const Access& access : task.access.all()) {
    const auto uses = [&](const auto& other) { return other.get() != &task && other->access.touches(access.column); };
    if (std::any_of(tasks_.begin(), tasks_.end(), uses)) continue;
    world_->for_all([&](Entity& entity) { entity.columns().drop(access.column); });
  }
}

/// Columns that this task has written and nobody writes now.
void Simulation::restart_columns_of(const Task& task) {
  for (const Access& access : task.access.all()) {
    if (access.mode != AccessMode::write) continue;
    const auto writes = [&](const auto& other) { return other.get() != &task && other->access.writes(access.column); };
    if (std::none_of(tasks_.begin(), tasks_.end(), writes)) access.entity->find(access.column->info().name)->restart();
  }
}

}  // namespace murosimf
