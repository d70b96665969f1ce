#include "murosimf/runtime/plan.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include <fmt/format.h>

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

  // the wave behind the last one in which somebody ...
  Waves<ColumnBase> touched_, written_;  // reads or writes the column, writes it
  Waves<Entity> entered_, claimed_;      // touches anything of the entity, claims it
};

}  // namespace

std::vector<Wave> make_waves(std::span<const std::size_t> due, std::span<const AccessSet* const> access) {
  std::vector<Wave> waves;
  FirstFreeWaves free;
  for (const std::size_t algorithm : due) {
    const std::size_t wave = free.for_algorithm(*access[algorithm]);
    free.put(*access[algorithm], wave);
    if (wave == waves.size()) waves.emplace_back();
    waves[wave].push_back(algorithm);
  }
  return waves;
}

Plan::Plan(std::vector<const AccessSet*> access, std::span<const Duration> periods, std::span<const std::string> names,
           Duration now)
    : access_(std::move(access)) {
  std::int64_t tick = 0;
  for (std::size_t i = 0; i < periods.size(); ++i) {
    const std::int64_t common = std::gcd(tick, static_cast<std::int64_t>(periods[i].count()));
    if (common < shortest_tick.count()) {
      throw SetupError(
          fmt::format("the rate of '{}', {:.6g} Hz, does not fit the rates of the others; the nearest that "
                      "does is {:.6g} Hz",
                      names[i], 1e9 / static_cast<double>(periods[i].count()), nearest_rate(periods[i].count(), tick)));
    }
    tick = common;
  }
  if (tick > 0) tick_ = Duration(std::gcd(tick, static_cast<std::int64_t>(now.count())));

  std::map<Duration, std::vector<std::size_t>> by_period;
  for (std::size_t i = 0; i < periods.size(); ++i) by_period[periods[i]].push_back(i);
  if (by_period.size() > most_groups) throw SetupError(fmt::format("more than {} different rates", most_groups));
  for (auto& [period, algorithms] : by_period) groups_.push_back({period / tick_, std::move(algorithms)});
}

const std::vector<Wave>& Plan::due(std::int64_t n) {
  std::uint64_t pattern = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (n % groups_[g].ticks == 0) pattern |= std::uint64_t{1} << g;
  }
  const auto found = waves_.find(pattern);
  if (found != waves_.end()) return found->second;

  std::vector<std::size_t> due;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (pattern >> g & 1) due.insert(due.end(), groups_[g].algorithms.begin(), groups_[g].algorithms.end());
  }
  std::sort(due.begin(), due.end());
  return waves_.emplace(pattern, make_waves(due, access_)).first->second;
}

}  // namespace murosimf
