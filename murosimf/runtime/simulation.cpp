#include "murosimf/runtime/simulation.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace murosimf {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr std::int64_t timed_every = 8;
constexpr double slowest_rate = 1e-3;  // [Hz]
constexpr double fastest_rate = 1e5;   // [Hz]

}  // namespace

Simulation::Simulation(int threads) : world_(std::make_unique<World>()), pool_(threads) {}

Simulation::~Simulation() = default;

void Simulation::run(Duration duration, Clock& clock, const std::function<void(Duration)>& progress) {
  if (duration < Duration{}) throw SetupError(fmt::format("duration {} s is negative", seconds(duration)));
  initialize();
  clock.start(now_);
  auto next_report = WallClock::now();
  for (const Duration end = now_ + duration; now_ < end;) {
    step();
    clock.wait_until(now_);
    if (progress && (ticks_ % 64 == 0 || now_ >= end) && (WallClock::now() >= next_report || now_ >= end)) {
      progress(now_);
      next_report = WallClock::now() + std::chrono::milliseconds(100);
    }
  }
}

void Simulation::run(Duration duration) {
  Clock as_fast_as_possible;
  run(duration, as_fast_as_possible);
}

void Simulation::step() {
  initialize();
  take_over_frozen();
  for (const Wave& wave : plan_.due(ticks_)) {
    pool_.for_each(wave.size(), [&](std::size_t i) { execute(*tasks_[wave[i]]); });
  }
  now_ += plan_.tick();
  ++ticks_;
  take_over_frozen();
}

void Simulation::initialize() {
  if (initialized_) return;
  std::vector<NamedAccess> named;
  std::vector<const AccessSet*> access;
  std::vector<Duration> periods;
  std::vector<std::string> names;
  for (const auto& task : tasks_) {
    named.push_back({fmt::format("{} of {}", task->name, task->entity->name()), &task->access});
    access.push_back(&task->access);
    periods.push_back(task->period);
    names.push_back(task->name);
  }
  check_every_read_is_written(named);
  plan_ = Plan(std::move(access), periods, names);
  world_->freeze_columns();
  for (std::size_t i = 0; i < tasks_.size(); ++i) at(named[i].algorithm, [&] { tasks_[i]->algorithm->initialize(); });
  initialized_ = true;
  for (const auto& call : after_initialize_) call();
}

std::unique_ptr<Simulation::Task> Simulation::new_task(std::string name, const Entity& entity, double rate_hz) const {
  if (initialized_) throw SetupError(fmt::format("'{}' is attached after the first step", name));
  if (!(rate_hz >= slowest_rate && rate_hz <= fastest_rate)) {
    throw SetupError(
        fmt::format("the rate of '{}', {} Hz, is not between {} and {} Hz", name, rate_hz, slowest_rate, fastest_rate));
  }
  auto task = std::make_unique<Task>();
  task->name = std::move(name);
  task->entity = &entity;
  task->period = from_seconds(1.0 / rate_hz);
  return task;
}

void Simulation::execute(Task& task) noexcept {
  if (task.frozen) return;
  const Instant instant{now_, task.period};
  if (task.calls++ % timed_every != 0) return task.algorithm->step(instant);
  const auto start = WallClock::now();
  task.algorithm->step(instant);
  task.time += WallClock::now() - start;
  ++task.timed_calls;
}

void Simulation::take_over_frozen() {
  const auto& entities = world_->entities();
  const auto frozen = [](const auto& entity) { return entity->frozen(); };
  const auto count = static_cast<std::size_t>(std::count_if(entities.begin(), entities.end(), frozen));
  if (count == frozen_reported_) return;
  frozen_reported_ = count;
  for (const auto& task : tasks_) task->frozen = task->entity->frozen();
  for (const auto& entity : entities) {
    const std::string beginning = fmt::format("'{}' was frozen", entity->name());
    const auto said = [&](const std::string& warning) { return warning.starts_with(beginning); };
    if (!entity->frozen() || std::any_of(warnings_.begin(), warnings_.end(), said)) continue;
    warnings_.push_back(fmt::format("{} at {:.3f} s: {}", beginning, seconds(now_), *entity->frozen_reason()));
  }
}

std::vector<AlgorithmStatistics> Simulation::statistics() const {
  struct Sum {
    AlgorithmStatistics row;
    std::int64_t timed = 0;
    Duration time{};
  };
  std::vector<Sum> sums;
  for (const auto& task : tasks_) {
    const double rate = 1.0 / seconds(task->period);
    auto sum = std::find_if(sums.begin(), sums.end(),
                            [&](const Sum& s) { return s.row.name == task->name && s.row.rate_hz == rate; });
    if (sum == sums.end()) sum = sums.insert(sums.end(), Sum{{task->name, rate, 0, 0}, 0, {}});
    sum->row.calls += task->calls;
    sum->timed += task->timed_calls;
    sum->time += task->time;
  }
  std::vector<AlgorithmStatistics> rows;
  for (Sum& sum : sums) {
    if (sum.timed > 0) sum.row.us_per_call = 1e6 * seconds(sum.time) / static_cast<double>(sum.timed);
    rows.push_back(std::move(sum.row));
  }
  return rows;
}

}  // namespace murosimf
