// What a simulation tells of its algorithms: order, costs, writers of a property.
#include <algorithm>
#include <map>

#include "murosimf/runtime/simulation.h"

namespace murosimf {

std::vector<std::string> Simulation::writers_of(const Entity& entity, std::string_view property) const {
  const ColumnBase* column = entity.find(property);
  std::vector<std::string> names;
  for (const auto& task : tasks_) {
    if (column && task->access.writes(column)) names.push_back(task->name);
  }
  return names;
}

std::vector<PlannedAlgorithm> Simulation::order_of_tick() {
  initialize();
  std::vector<PlannedAlgorithm> order;
  const std::vector<Wave> waves = plan_.all();
  for (std::size_t i = 0; i < waves.size(); ++i) {
    for (const std::size_t number : waves[i]) {
      const Task& task = *tasks_[number];
      order.push_back({i, task.algorithm->phase(), task.name, task.entity->name(), task.rate.hz});
    }
  }
  return order;
}

std::vector<AlgorithmStatistics> Simulation::statistics() const {
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

}  // namespace murosimf
