#include "murosimf/runtime/plan.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf {
namespace {

constexpr Duration shortest_tick = std::chrono::microseconds(10);
constexpr std::size_t most_groups = 64;

/// The rate [Hz] nearest to a period [ns] whose common divisor with `tick` [ns] is long enough: multiples of the
/// smallest divisor of the tick that is.
double nearest_rate(std::int64_t period, std::int64_t tick) {
  std::int64_t divisor = shortest_tick.count();
  while (tick > 0 && tick % divisor != 0) ++divisor;
  const std::int64_t multiples = std::max<std::int64_t>(1, (period + divisor / 2) / divisor);
  return 1e9 / static_cast<double>(multiples * divisor);
}

/// [ns] The divisor of `tick` and the period of `task`.
std::int64_t with_period_of(const PlannedTask& task, std::int64_t tick) {
  const auto period = static_cast<std::int64_t>(task.rate.period().count());
  const std::int64_t common = std::gcd(tick, period);
  if (common >= shortest_tick.count()) return common;
  throw SetupError(
      fmt::format("the rate of '{}', {:.6g} Hz, does not fit the rates of the others; the nearest that "
                  "does is {:.6g} Hz",
                  task.name, 1e9 / static_cast<double>(period), nearest_rate(period, tick)));
}

/// [ns] 0 if there are no tasks.
std::int64_t common_tick(std::span<const PlannedTask> tasks) {
  const bool something_steps = std::any_of(tasks.begin(), tasks.end(), [](const auto& task) { return task.steps; });
  std::int64_t tick = 0;
  for (const PlannedTask& task : tasks) {
    if (task.steps || !something_steps) tick = with_period_of(task, tick);
  }
  const std::int64_t step = tick;
  for (const PlannedTask& task : tasks) {
    if (task.rate.period().count() < step) tick = with_period_of(task, tick);
  }
  return tick;
}

/// The first wave after those of all earlier algorithms with which one conflicts, by what these touch: asking each pair of
/// algorithms takes too long where hundreds of robots see each other.
class FirstFreeWaves {
 public:
  [[nodiscard]] std::size_t for_algorithm(const AccessSet& access) const {
    std::size_t wave = 0;
    for (const Access& a : access.all()) {
      const bool writes = a.mode == AccessMode::write;
      wave = std::max({wave, after(writes ? touched_ : written_, a.column), after(claimed_, a.entity)});
    }
    for (const Entity* entity : access.claimed()) wave = std::max(wave, after(entered_, entity));
    return wave;
  }

  void put(const AccessSet& access, std::size_t wave) {
    for (const Access& a : access.all()) {
      raise(touched_[a.column], wave + 1);
      raise(entered_[a.entity], wave + 1);
      if (a.mode == AccessMode::write) raise(written_[a.column], wave + 1);
    }
    for (const Entity* entity : access.claimed()) raise(claimed_[entity], wave + 1);
  }

 private:
  template <class Key>
  using Waves = std::unordered_map<const Key*, std::size_t>;

  template <class Key>
  static std::size_t after(const Waves<Key>& waves, const Key* key) {
    const auto found = waves.find(key);
    return found == waves.end() ? 0 : found->second;
  }
  static void raise(std::size_t& wave, std::size_t to) { wave = std::max(wave, to); }

  // the wave behind the last one in which an algorithm ...
  Waves<ColumnBase> touched_, written_;  // reads or writes the column, writes it
  Waves<Entity> entered_, claimed_;      // touches anything of the entity, claims it
};

}  // namespace

std::vector<Wave> make_waves(std::span<const std::size_t> due, std::span<const AccessSet* const> access) {
  std::vector<Wave> waves;
  FirstFreeWaves free;
  for (const std::size_t algorithm : due) {
    MUROSIMF_ASSERT(algorithm < access.size() && access[algorithm]);
    const std::size_t wave = free.for_algorithm(*access[algorithm]);
    MUROSIMF_ASSERT(wave <= waves.size() && "behind those of earlier algorithms there is at most one that is new");
    free.put(*access[algorithm], wave);
    if (wave == waves.size()) waves.emplace_back();
    waves[wave].push_back(algorithm);
  }
  return waves;
}

Plan::Plan(std::span<const PlannedTask> tasks, Duration now) {
  const std::int64_t tick = common_tick(tasks);
  MUROSIMF_ASSERT(now >= Duration{});
  if (tick > 0) tick_ = Duration(std::gcd(tick, static_cast<std::int64_t>(now.count())));
  MUROSIMF_ASSERT(tick_ > Duration{} && now % tick_ == Duration{});

  std::map<Rate, std::vector<std::size_t>> by_rate;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    access_.push_back(tasks[i].access);
    by_rate[tasks[i].rate].push_back(i);
  }
  if (by_rate.size() > most_groups) throw SetupError(fmt::format("more than {} different rates", most_groups));
  for (auto& [rate, algorithms] : by_rate) {
    const bool multiples = rate.phase == 0 && rate.period() % tick_ == Duration{};
    groups_.push_back({rate, multiples ? rate.period() / tick_ : 0, std::move(algorithms)});
  }
}

bool Plan::is_due(const Group& group, std::int64_t n) const {
  MUROSIMF_ASSERT(tick_ > Duration{} && n >= 0);
  return group.ticks > 0 ? n % group.ticks == 0 : group.rate.falls_on(n * tick_, tick_);
}

std::vector<Wave> Plan::all() const {
  std::vector<std::size_t> all(access_.size());
  std::iota(all.begin(), all.end(), 0U);
  return make_waves(all, access_);
}

const std::vector<Wave>& Plan::due(std::int64_t n) {
  MUROSIMF_ASSERT(n >= 0 && groups_.size() <= most_groups);
  std::uint64_t pattern = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (is_due(groups_[g], n)) pattern |= std::uint64_t{1} << g;
  }
  const auto found = waves_.find(pattern);
  if (found != waves_.end()) return found->second;

  std::vector<std::size_t> due;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (pattern >> g & 1) due.insert(due.end(), groups_[g].algorithms.begin(), groups_[g].algorithms.end());
  }
  // in the order of phases and attaching, whatever their rates
  std::sort(due.begin(), due.end());
  MUROSIMF_ASSERT(std::adjacent_find(due.begin(), due.end()) == due.end() && "an algorithm is in one group");
  return waves_.emplace(pattern, make_waves(due, access_)).first->second;
}

}  // namespace murosimf
