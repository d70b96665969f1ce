/// task_list.h - all attached algorithms in the order of a tick, and what those have cost that are there no more.
///
/// The number of a task is its place in that order: plans (plan.h) and jobs (lane_jobs.h) speak of tasks by number, and are made anew
/// whenever the list changes. Tasks stay where they are in memory.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/runtime/task.h"

namespace murosimf {

/// What one kind of algorithm has cost.
struct AlgorithmStatistics {
  std::string name;
  double rate_hz = 0;
  std::int64_t calls = 0;
  double us_per_call =
      0;  ///< mean; after the first 64 calls from every eighth: taking the time of all would slow them down
};

class TaskList {
 public:
  using Place = std::vector<std::unique_ptr<Task>>::iterator;

  [[nodiscard]] Place begin() noexcept { return tasks_.begin(); }
  [[nodiscard]] Place end() noexcept { return tasks_.end(); }
  [[nodiscard]] auto begin() const noexcept { return tasks_.begin(); }
  [[nodiscard]] auto end() const noexcept { return tasks_.end(); }
  [[nodiscard]] std::size_t size() const noexcept { return tasks_.size(); }
  [[nodiscard]] Task& operator[](std::size_t number) const noexcept {
    MUROSIMF_ASSERT(number < tasks_.size());
    return *tasks_[number];
  }

  /// Behind all of the same or an earlier phase.
  void add(std::unique_ptr<Task> task);
  /// Takes a task out; put_back() undoes it.
  [[nodiscard]] std::unique_ptr<Task> take(Place place);
  void put_back(std::size_t number, std::unique_ptr<Task> task);
  /// Takes out those that come along with an entity.
  [[nodiscard]] std::vector<std::unique_ptr<Task>> take_those_that_come_along();
  /// Of one that was taken out: destroys the algorithm and keeps its costs.
  void retire(std::unique_ptr<Task> task);

  /// end(): there is none.
  [[nodiscard]] Place find(const Task& task);
  [[nodiscard]] Place find(const Algorithm& algorithm);
  [[nodiscard]] Place level_task(const Entity& entity);

  /// Null if nothing moves the entity.
  [[nodiscard]] const MotionLevel* level_of(const Entity& entity) const;
  /// Names of the algorithms that write a property of an entity while stepping.
  [[nodiscard]] std::vector<std::string> writers_of(const Entity& entity, std::string_view property) const;
  /// Whether a task besides this one reads or writes the column; writes it.
  [[nodiscard]] bool others_use(const Task& task, const ColumnBase* column) const;
  [[nodiscard]] bool others_write(const Task& task, const ColumnBase* column) const;

  /// Copies from all entities whether they are idle. Between two ticks.
  void take_over_idle() noexcept;
  /// One row per name and rate, in the order of a tick, then those of tasks that are there no more.
  [[nodiscard]] std::vector<AlgorithmStatistics> statistics() const;
  /// From now on costs count from zero.
  void forget_costs() noexcept;

 private:
  std::vector<std::unique_ptr<Task>> tasks_;    // by phase, then by order of attaching
  std::vector<std::unique_ptr<Task>> retired_;  // without algorithm
};

}  // namespace murosimf
