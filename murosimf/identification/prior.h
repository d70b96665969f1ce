/// prior.h - knowledge about a servo before a fit.
///
/// Each known number has a value and a width, like the standard deviation of a normal distribution, of the
/// number or of its logarithm. A width away costs as much as 0.5 mrad more error of position; the cost grows with the
/// square. So logs decide what they determine, and the prior decides the rest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/identification/parameter.h"

namespace murosimf::identification {

struct Expectation {
  std::string parameter;  ///< its name
  double value = 0;       ///< in its unit
  double width = 1;       ///< in its unit, or without unit if relative
  bool relative = false;  ///< of ln(x/value)
};

using Prior = std::vector<Expectation>;

/// [rad] The cost of a parameter's value; 0 if the prior does not name it.
[[nodiscard]] double cost_of(const Prior& prior, const Parameter& parameter, double value);

/// The expected value of the parameter; nothing if the prior does not name it.
[[nodiscard]] std::optional<double> expected_value(const Prior& prior, const Parameter& parameter);

/// The parameter with bounds at most five widths from the expected value: a search need not go farther.
[[nodiscard]] Parameter narrowed(const Prior& prior, const Parameter& parameter);

}  // namespace murosimf::identification
