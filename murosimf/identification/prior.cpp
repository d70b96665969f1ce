#include "murosimf/identification/prior.h"

#include <algorithm>
#include <cmath>

namespace murosimf::identification {
namespace {

constexpr double cost_of_a_width = 0.5e-3;  // [rad]

const Expectation* find(const Prior& prior, const Parameter& parameter) {
  const auto found = std::ranges::find(prior, parameter.name, &Expectation::parameter);
  return found == prior.end() ? nullptr : &*found;
}

}  // namespace

double cost_of(const Prior& prior, const Parameter& parameter, double value) {
  const Expectation* expected = find(prior, parameter);
  if (!expected) return 0;
  const double away = expected->relative ? std::log(value / expected->value) : value - expected->value;
  return cost_of_a_width * (away / expected->width) * (away / expected->width);
}

double expected_value(const Prior& prior, const Parameter& parameter) {
  const Expectation* expected = find(prior, parameter);
  return expected ? expected->value : value_at(parameter, 0.5);
}

}  // namespace murosimf::identification
