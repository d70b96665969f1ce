/// algorithm_registry.h - the participants of a simulation: algorithms are attached, detached and exchanged, entities come and go.
///
/// Each of these is done between two steps, and done as a whole: what throws a SetupError leaves world, tasks and plan as they were.
/// Before the first start algorithms are only constructed; what comes later is initialized at once. Simulation says what each means for
/// its callers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "murosimf/runtime/event_log.h"
#include "murosimf/runtime/scheduler.h"
#include "murosimf/runtime/task_list.h"
#include "murosimf/world/motion_level.h"
#include "murosimf/world/rate.h"
#include "murosimf/world/world.h"

namespace murosimf {

template <class A>
using AlgorithmMaker = std::function<std::unique_ptr<A>(Setup&)>;

/// How a level that takes the place of another one begins.
enum class LevelStart {
  in_motion,  ///< goes on from the present state; refuses if it cannot
  anew,       ///< as at the beginning of a run: a state will be loaded before the next step
};

class AlgorithmRegistry {
 public:
  /// All outlive it.
  AlgorithmRegistry(World& world, TaskList& tasks, Scheduler& scheduler, EventLog& log)
      : world_(world), tasks_(tasks), scheduler_(scheduler), log_(log) {}

  Algorithm& attach(std::string name, Entity& entity, const Rate& rate, const AlgorithmMaker<Algorithm>& make);
  void detach(const Algorithm& algorithm);
  MotionLevel& exchange(std::string name, Entity& entity, const AlgorithmMaker<MotionLevel>& make, LevelStart start);
  void exchange_model(Entity& entity, ModelPtr model, const AlgorithmMaker<MotionLevel>& level, LevelStart start);

  Entity& add(std::string name, ModelPtr model, const EntityOptions& options,
              const std::function<void(Entity&)>& furnish, const std::function<void(Entity&)>& prepare);
  void leave(Entity& entity);
  void enter(Entity& entity, const std::function<void(Entity&)>& prepare);

  /// Freezes the columns of the world and keeps what the first start begins with.
  void keep_start();
  void go_back_to_start();
  /// All algorithms give what they write its first values.
  void initialize_all();
  /// Whether initialize_all() has been there.
  [[nodiscard]] bool started() const noexcept { return started_; }

  /// Between two ticks: tasks of entities that have been frozen since the last call stand still, and warnings say why.
  void take_over_frozen();
  void reseed(std::uint64_t seed);
  void state(StateArchive& archive);

 private:
  void construct(Task& task, Entity& entity, const AlgorithmMaker<Algorithm>& make);
  void start_late(Task& added);
  void construct_level(Task& task, Entity& entity, const AlgorithmMaker<MotionLevel>& make, LevelStart start);
  void put_in_place_of(std::unique_ptr<Task>& present, std::unique_ptr<Task>& next, LevelStart start);
  void keep_new_columns(const Task& task);
  void drop_columns_of(const Task& task);
  void restart_columns_of(const Task& task);

  void attach_all(Entity& entity, const std::function<void(Entity&)>& furnish);
  void tell_of(Entity& entity);
  void begin(Entity& entity, const std::function<void(Entity&)>& prepare);
  void keep_start_of(Entity& entity);
  void start_again(Entity& entity, const std::function<void(Entity&)>& prepare);
  void take_back(Entity& entity);

  World& world_;
  TaskList& tasks_;
  Scheduler& scheduler_;
  EventLog& log_;
  bool started_ = false;
  bool adds_ = false;  // an entity; what is attached meanwhile is initialized when all of it is there
  std::size_t frozen_reported_ = 0;
};

}  // namespace murosimf
