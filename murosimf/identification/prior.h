/// prior.h - what is known of a servo before a log is looked at.
///
/// Each number that is known has a value and a width, as the standard deviation of a normal distribution has, of the
/// number or of its logarithm. A width away costs as much as 0.5 mrad more error of position; the cost grows with the
/// square. So logs decide what they can tell, and the prior what they cannot.
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

/// [rad] what the value of a parameter costs; 0 if nothing is expected of it.
[[nodiscard]] double cost_of(const Prior& prior, const Parameter& parameter, double value);

/// What is expected of the parameter; nothing if the prior does not name it.
[[nodiscard]] std::optional<double> expected_value(const Prior& prior, const Parameter& parameter);

/// The parameter with bounds at most five widths from what is expected: a search need not look farther.
[[nodiscard]] Parameter narrowed(const Prior& prior, const Parameter& parameter);

}  // namespace murosimf::identification
