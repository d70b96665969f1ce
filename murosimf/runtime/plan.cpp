#include "murosimf/runtime/plan.h"

#include <algorithm>
#include <numeric>

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

}  // namespace

std::vector<Wave> make_waves(std::span<const std::size_t> due, std::span<const AccessSet* const> access) {
  std::vector<Wave> waves;
  for (const std::size_t algorithm : due) {
    std::size_t wave = 0;
    for (std::size_t earlier = waves.size(); earlier-- > 0 && wave == 0;) {
      const bool clash = std::any_of(waves[earlier].begin(), waves[earlier].end(),
                                     [&](std::size_t other) { return conflict(*access[algorithm], *access[other]); });
      if (clash) wave = earlier + 1;
    }
    if (wave == waves.size()) waves.emplace_back();
    waves[wave].push_back(algorithm);
  }
  return waves;
}

Plan::Plan(std::vector<const AccessSet*> access, std::span<const Duration> periods, std::span<const std::string> names)
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
  if (tick > 0) tick_ = Duration(tick);

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
