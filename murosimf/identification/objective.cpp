#include "murosimf/identification/objective.h"

#include <algorithm>
#include <numeric>

#include "murosimf/math/assert.h"

namespace murosimf::identification {
namespace {

constexpr double window = 0.6;           // [s]
constexpr double rate_interval = 0.015;  // [s] before and after, over which a starting rate is measured
constexpr double scale_of_windows = 4;

std::size_t entry_at(const ServoLog& log, double time) {
  MUROSIMF_ASSERT(!log.samples.empty());
  const auto later = std::ranges::lower_bound(log.samples, time, {}, &ServoSample::time);
  return static_cast<std::size_t>(std::min(later, log.samples.end() - 1) - log.samples.begin());
}

/// [rad/s] From the encoder: the servo's own estimate of its rate lags by 20 ms.
double rate_at(const ServoLog& log, std::size_t entry) {
  MUROSIMF_ASSERT(entry < log.samples.size());
  const double time = log.samples[entry].time;
  const ServoSample& before = log.samples[entry_at(log, time - rate_interval)];
  const ServoSample& after = log.samples[entry_at(log, time + rate_interval)];
  return (after.position - before.position) / (after.time - before.time);
}

std::vector<Piece> whole_logs(std::span<const ServoLog> logs) {
  std::vector<Piece> pieces;
  for (const ServoLog& log : logs) pieces.push_back(whole(log));
  return pieces;
}

/// Windows of the logs, one after the other. A log shorter than one has none.
std::vector<Piece> windows_of(std::span<const ServoLog> logs) {
  std::vector<Piece> pieces;
  for (const ServoLog& log : logs) {
    for (double start = 2 * rate_interval; start + window < log.samples.back().time; start += window) {
      const std::size_t first = entry_at(log, start), last = entry_at(log, start + window);
      if (last > first) pieces.push_back({&log, first, last, rate_at(log, first)});
    }
  }
  return pieces;
}

double mean(const std::vector<double>& numbers) {
  return numbers.empty() ? 0
                         : std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

}  // namespace

Objective::Objective(const FrictionModel& model, const Prior& prior, std::span<const ServoLog> logs,
                     const ObjectiveOptions& options)
    : prior_(prior),
      options_(options),
      logs_(whole_logs(logs), options.duty_per_gain, options.step),
      windows_(windows_of(logs), options.duty_per_gain, options.step),
      errors_(logs_.size()),
      window_errors_(windows_.size()) {
  if (windows_.size() == 0) options_.window_share = 0;
  for (const Parameter* parameter : model.parameters) parameters_.push_back(narrowed(prior, *parameter));
}

multibody::BenchServo Objective::servo_at(std::span<const double> places) const {
  MUROSIMF_ASSERT(places.size() == parameters_.size());
  multibody::BenchServo servo{.duty_limit = options_.duty_limit, .current_limit = options_.current_limit};
  for (std::size_t i = 0; i < places.size(); ++i) {
    parameters_[i].set(servo, value_at(parameters_[i], places[i]));
  }
  return servo;
}

double Objective::operator()(std::span<const double> places) {
  MUROSIMF_ASSERT(places.size() == parameters_.size());
  const multibody::BenchServo servo = servo_at(places);
  double cost = 0;
  // The prior costs in the unit of the errors, so that both add up.
  for (std::size_t i = 0; i < places.size(); ++i) {
    cost += cost_of(prior_, parameters_[i], value_at(parameters_[i], places[i]));
  }
  logs_.errors(servo, errors_);
  cost += (1 - options_.window_share) * mean(errors_);
  if (options_.window_share == 0) return cost;
  windows_.errors(servo, window_errors_);
  return cost + options_.window_share * scale_of_windows * mean(window_errors_);
}

}  // namespace murosimf::identification
