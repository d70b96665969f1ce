#include "murosimf/identification/window_choice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "murosimf/math/assert.h"

namespace murosimf::identification {
namespace {

double mean_of(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

/// Whether the errors of `other` are lower than those of `one` by more than chance explains.
bool clearly_lower(const std::vector<double>& other, const std::vector<double>& one) {
  MUROSIMF_ASSERT(other.size() == one.size());
  const auto count = static_cast<double>(one.size());
  std::vector<double> lower;
  for (std::size_t i = 0; i < one.size(); ++i) lower.push_back(one[i] - other[i]);
  const double mean = mean_of(lower);
  double square = 0;
  for (const double difference : lower) square += (difference - mean) * (difference - mean);
  return count > 1 && mean > 2 * std::sqrt(square / (count - 1) / count);
}

}  // namespace

double mean_error(const WindowTrial& trial) { return mean_of(trial.errors); }

std::size_t best_trial(std::span<const WindowTrial> trials, std::size_t usual) {
  MUROSIMF_ASSERT(usual < trials.size());
  std::size_t best = usual;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (!clearly_lower(trials[i].errors, trials[usual].errors)) continue;
    if (mean_error(trials[i]) < mean_error(trials[best])) best = i;
  }
  return best;
}

double usual_window_share(const FrictionModel& model) {
  const auto follows_load = [](const Parameter* parameter) { return parameter->name.ends_with("load_friction"); };
  return std::ranges::any_of(model.parameters, follows_load) ? 0.8 : 0;
}

}  // namespace murosimf::identification
