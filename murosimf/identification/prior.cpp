#include "murosimf/identification/prior.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::identification {
namespace {

constexpr double cost_of_a_width = 0.5e-3;  // [rad]
constexpr double widest = 5;                // widths

const Expectation* find(const Prior& prior, const Parameter& parameter) {
  const auto found = std::ranges::find(prior, parameter.name, &Expectation::parameter);
  return found == prior.end() ? nullptr : &*found;
}

}  // namespace

double cost_of(const Prior& prior, const Parameter& parameter, double value) {
  const Expectation* expected = find(prior, parameter);
  if (!expected) return 0;
  MUROSIMF_ASSERT(expected->width > 0);
  const double away = expected->relative ? std::log(value / expected->value) : value - expected->value;
  return cost_of_a_width * (away / expected->width) * (away / expected->width);
}

std::optional<double> expected_value(const Prior& prior, const Parameter& parameter) {
  const Expectation* expected = find(prior, parameter);
  return expected ? std::optional(expected->value) : std::nullopt;
}

Parameter narrowed(const Prior& prior, const Parameter& parameter) {
  Parameter narrow = parameter;
  const Expectation* expected = find(prior, parameter);
  if (!expected) return narrow;
  const double reach = widest * expected->width;
  const double low = expected->relative ? expected->value * std::exp(-reach) : expected->value - reach;
  const double high = expected->relative ? expected->value * std::exp(reach) : expected->value + reach;
  narrow.low = std::max(parameter.low, low);
  narrow.high = std::min(parameter.high, high);
  MUROSIMF_ASSERT(narrow.low <= narrow.high);
  return narrow;
}

}  // namespace murosimf::identification
