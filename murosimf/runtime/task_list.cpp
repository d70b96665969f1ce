#include "murosimf/runtime/task_list.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace murosimf {

void TaskList::add(std::unique_ptr<Task> task) {
  MUROSIMF_ASSERT(task && task->algorithm);
  const auto later = [&](Phase phase, const auto& other) { return phase < other->algorithm->phase(); };
  tasks_.insert(std::upper_bound(tasks_.begin(), tasks_.end(), task->algorithm->phase(), later), std::move(task));
}

std::unique_ptr<Task> TaskList::take(Place place) {
  MUROSIMF_ASSERT(place != tasks_.end());
  std::unique_ptr<Task> task = std::move(*place);
  tasks_.erase(place);
  return task;
}

void TaskList::put_back(std::size_t number, std::unique_ptr<Task> task) {
  MUROSIMF_ASSERT(number <= tasks_.size());
  tasks_.insert(tasks_.begin() + static_cast<std::ptrdiff_t>(number), std::move(task));
}

std::vector<std::unique_ptr<Task>> TaskList::take_those_that_come_along() {
  const auto first = std::ranges::stable_partition(tasks_, [](const auto& task) { return !task->comes_along; }).begin();
  std::vector<std::unique_ptr<Task>> taken(std::make_move_iterator(first), std::make_move_iterator(tasks_.end()));
  tasks_.erase(first, tasks_.end());
  return taken;
}

void TaskList::retire(std::unique_ptr<Task> task) {
  task->algorithm.reset();
  retired_.push_back(std::move(task));
}

auto TaskList::find(const Task& task) -> Place {
  return std::find_if(tasks_.begin(), tasks_.end(), [&](const auto& other) { return other.get() == &task; });
}

auto TaskList::find(const Algorithm& algorithm) -> Place {
  return std::find_if(tasks_.begin(), tasks_.end(),
                      [&](const auto& task) { return task->algorithm.get() == &algorithm; });
}

auto TaskList::level_task(const Entity& entity) -> Place {
  return std::find_if(tasks_.begin(), tasks_.end(),
                      [&](const auto& task) { return task->level && task->entity == &entity; });
}

const MotionLevel* TaskList::level_of(const Entity& entity) const {
  for (const auto& task : tasks_) {
    if (task->level && task->entity == &entity) return task->level;
  }
  return nullptr;
}

std::vector<std::string> TaskList::writers_of(const Entity& entity, std::string_view property) const {
  const ColumnBase* column = entity.find(property);
  std::vector<std::string> names;
  for (const auto& task : tasks_) {
    if (column && task->access.writes(column)) names.push_back(task->name);
  }
  return names;
}

bool TaskList::others_use(const Task& task, const ColumnBase* column) const {
  const auto uses = [&](const auto& other) { return other.get() != &task && other->access.touches(column); };
  return std::any_of(tasks_.begin(), tasks_.end(), uses);
}

bool TaskList::others_write(const Task& task, const ColumnBase* column) const {
  const auto writes = [&](const auto& other) { return other.get() != &task && other->access.writes(column); };
  return std::any_of(tasks_.begin(), tasks_.end(), writes);
}

void TaskList::take_over_idle() noexcept {
  for (const auto& task : tasks_) task->idle = task->entity->idle();
}

std::vector<AlgorithmStatistics> TaskList::statistics() const {
  struct Sum {
    AlgorithmStatistics row;
    std::int64_t timed = 0;
    Duration time{};
  };
  std::vector<Sum> sums;
  const auto add = [&](const std::unique_ptr<Task>& task) {
    const double rate = task->rate.hz;
    auto sum = std::find_if(sums.begin(), sums.end(),
                            [&](const Sum& s) { return s.row.name == task->name && s.row.rate_hz == rate; });
    if (sum == sums.end()) sum = sums.insert(sums.end(), Sum{{task->name, rate, 0, 0}, 0, {}});
    sum->row.calls += task->calls;
    sum->timed += task->timed_calls;
    sum->time += task->time;
  };
  std::for_each(tasks_.begin(), tasks_.end(), add);
  std::for_each(retired_.begin(), retired_.end(), add);
  std::vector<AlgorithmStatistics> rows;
  for (Sum& sum : sums) {
    if (sum.timed > 0) sum.row.us_per_call = 1e6 * seconds(sum.time) / static_cast<double>(sum.timed);
    rows.push_back(std::move(sum.row));
  }
  return rows;
}

void TaskList::forget_costs() noexcept {
  for (const auto& task : tasks_) {
    task->calls = task->timed_calls = 0;
    task->time = {};
  }
  retired_.clear();
}

}  // namespace murosimf
