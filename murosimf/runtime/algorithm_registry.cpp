#include "murosimf/runtime/algorithm_registry.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/floating_point.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/runtime/start_state.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {

Algorithm& AlgorithmRegistry::attach(std::string name, Entity& entity, const Rate& rate,
                                     const AlgorithmMaker<Algorithm>& make) {
  auto task = new_task(std::move(name), entity, rate);
  construct(*task, entity, make);
  Task& added = *task;
  task->comes_along = adds_;
  tasks_.add(std::move(task));  // last: a constructor that throws leaves nothing behind
  if (started_ && !adds_) start_late(added);
  if (added.level) entity.level = added.name;
  return *added.algorithm;
}

void AlgorithmRegistry::construct(Task& task, Entity& entity, const AlgorithmMaker<Algorithm>& make) {
  world_.thaw_columns();
  try {
    Setup setup(world_, entity, task.access, task.period);
    task.algorithm = make(setup);
    follow_step_multiple(task, setup);
    task.level = dynamic_cast<MotionLevel*>(task.algorithm.get());
    if (task.level && tasks_.level_task(entity) != tasks_.end()) {
      throw SetupError(
          fmt::format("'{}' cannot move '{}', which another level moves already", task.name, entity.name()));
    }
  } catch (...) {
    if (started_) {
      drop_columns_of(task);
      world_.freeze_columns();
    }
    throw;
  }
  if (started_) world_.freeze_columns();
}

/// What initialize() does for all, for one that came later.
void AlgorithmRegistry::start_late(Task& added) {
  try {
    scheduler_.plan();
    keep_new_columns(added);
    keep_memory(added);
    murosimf::with_context(full_name(added), [&] { added.algorithm->initialize(); });
  } catch (...) {
    const std::unique_ptr<Task> refused = tasks_.take(tasks_.find(added));
    drop_columns_of(*refused);
    scheduler_.plan();
    scheduler_.restart_checks();
    throw;
  }
  scheduler_.restart_checks();
}

/// Those that only this task uses.
void AlgorithmRegistry::keep_new_columns(const Task& task) {
  for (const Access& access : task.access.all()) {
    if (!tasks_.others_use(task, access.column)) access.entity->find(access.column->info().name)->keep();
  }
}

void AlgorithmRegistry::detach(const Algorithm& algorithm) {
  const auto place = tasks_.find(algorithm);
  if (place == tasks_.end()) throw SetupError("an algorithm is detached that is not attached");
  if ((*place)->level) {
    throw SetupError(
        fmt::format("'{}' moves '{}': exchange it for another level", (*place)->name, (*place)->entity->name()));
  }
  const auto number = static_cast<std::size_t>(place - tasks_.begin());
  std::unique_ptr<Task> task = tasks_.take(place);
  try {
    if (started_) scheduler_.plan();
  } catch (const SetupError& error) {
    tasks_.put_back(number, std::move(task));
    scheduler_.plan();
    throw SetupError(fmt::format("'{}' stays: {}", full_name(tasks_[number]), error.what()));
  }
  restart_columns_of(*task);
  drop_columns_of(*task);
  if (started_) scheduler_.restart_checks();
  tasks_.retire(std::move(task));
}

MotionLevel& AlgorithmRegistry::exchange(std::string name, Entity& entity, const AlgorithmMaker<MotionLevel>& make,
                                         LevelStart start) {
  if (!entity.present()) start = LevelStart::anew;  // it begins when it enters
  const auto present = tasks_.level_task(entity);
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
    if (started_) scheduler_.restart_checks();
    throw SetupError(
        fmt::format("'{}' stays at {}: no {}: {}", entity.name(), (*present)->name, next->name, error.what()));
  }
  // `next` is now what was there before
  restart_columns_of(*next);
  drop_columns_of(*next);
  if (started_) scheduler_.restart_checks();
  entity.level = name;
  if (name != next->name) log_.record(scheduler_.now(), fmt::format("{}: {} -> {}", entity.name(), next->name, name));
  tasks_.retire(std::move(next));
  return *(*present)->level;
}

void AlgorithmRegistry::exchange_model(Entity& entity, ModelPtr model, const AlgorithmMaker<MotionLevel>& level,
                                       LevelStart start) {
  const ModelPtr before = entity.model_ptr();  // algorithms point into it until they have been told
  const bool moves = started_ && entity.present() && start == LevelStart::in_motion;
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
void AlgorithmRegistry::construct_level(Task& task, Entity& entity, const AlgorithmMaker<MotionLevel>& make,
                                        LevelStart start) {
  world_.thaw_columns();
  Setup setup(world_, entity, task.access, task.period);
  try {
    auto level = make(setup);
    task.level = level.get();
    task.algorithm = std::move(level);
    follow_step_multiple(task, setup);
  } catch (const SetupError&) {
    if (started_) world_.freeze_columns();
    throw;
  }
  if (!started_) return;
  world_.freeze_columns();
  keep_new_columns(task);
  keep_memory(task);
  if (start == LevelStart::anew) return;
  if (const std::string why = task.level->refusal(); !why.empty()) throw SetupError(why);
}

/// Swaps the two, and has the motion handed over; on an error everything is as before. The level before hands over only once the plan
/// stands: from then on nothing but the new level's own refusal can fail, and the momentum goes back where it came from.
void AlgorithmRegistry::put_in_place_of(std::unique_ptr<Task>& present, std::unique_ptr<Task>& next, LevelStart start) {
  std::swap(present, next);
  if (!started_) return;
  std::optional<Momentum> momentum;
  try {
    scheduler_.plan();
    momentum = next->level->hand_over();
    start == LevelStart::anew ? present->level->initialize() : present->level->take_over(*momentum);
  } catch (const SetupError&) {
    std::swap(present, next);
    scheduler_.plan();
    if (momentum) present->level->take_over(*momentum);
    throw;
  }
}

/// Columns that only this task has used.
void AlgorithmRegistry::drop_columns_of(const Task& task) {
  for (const Access& access : task.access.all()) {
    if (tasks_.others_use(task, access.column)) continue;
    world_.for_all([&](Entity& entity) { entity.columns().drop(access.column); });
  }
}

/// Columns that this task has written and no other task writes.
void AlgorithmRegistry::restart_columns_of(const Task& task) {
  for (const Access& access : task.access.all()) {
    if (access.mode != AccessMode::write) continue;
    if (tasks_.others_write(task, access.column)) continue;
    access.entity->find(access.column->info().name)->restart();
  }
}

void AlgorithmRegistry::keep_start() {
  world_.freeze_columns();
  world_.for_all([](Entity& entity) { keep_columns(entity); });
  for (const auto& task : tasks_) keep_memory(*task);
}

void AlgorithmRegistry::go_back_to_start() {
  world_.for_all([](Entity& entity) { murosimf::go_back_to_start(entity); });
  for (const auto& task : tasks_) recall_first(*task);
  tasks_.forget_costs();
  frozen_reported_ = 0;
}

void AlgorithmRegistry::initialize_all() {
  for (const auto& task : tasks_) {
    const KeptFloatingPoint of_others;
    murosimf::with_context(full_name(*task), [&] { task->algorithm->initialize(); });
  }
  started_ = true;
  tasks_.take_over_idle();
}

void AlgorithmRegistry::reseed(std::uint64_t seed) {
  for (const auto& task : tasks_) task->algorithm->reseed(seed);
}

/// What is frozen has its reason in a warning, once, also if it had been frozen when a state was saved.
void AlgorithmRegistry::take_over_frozen() {
  const auto& entities = world_.entities();
  const auto frozen = [](const auto& entity) { return entity->frozen(); };
  const auto count = static_cast<std::size_t>(std::count_if(entities.begin(), entities.end(), frozen));
  if (count == frozen_reported_) return;
  frozen_reported_ = count;
  tasks_.take_over_idle();
  const auto& warnings = log_.warnings();
  for (const auto& entity : entities) {
    const std::string beginning = fmt::format("'{}' was frozen", entity->name());
    const auto said = [&](const std::string& warning) { return warning.starts_with(beginning); };
    if (!entity->frozen() || std::any_of(warnings.begin(), warnings.end(), said)) continue;
    log_.warn(fmt::format("{} at {:.3f} s: {}", beginning, seconds(scheduler_.now()), *entity->frozen_reason()));
  }
}

void AlgorithmRegistry::state(StateArchive& archive) { archive(frozen_reported_); }

}  // namespace murosimf
