/// range.h - between which distances a sensor sees something: the options range_min and range_max.
#pragma once

#include <limits>

#include "murosimf/model/option.h"

namespace murosimf::sensors {

/// Between which distances [m] a sensor sees something.
struct Range {
  double min = 0, max = std::numeric_limits<double>::infinity();

  /// A distance as it is shown: -infinity if it is too small, +infinity if it is too big or there is nothing (REP-117).
  [[nodiscard]] double shown(double distance) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return distance < min ? -infinity : distance > max ? infinity : distance;
  }
};

/// Throws SetupError if nothing is between them; else the same.
[[nodiscard]] const Range& checked(const Range& range);

/// Row of an option of structs with a member `Range range`.
template <class Options>
[[nodiscard]] typename OptionTable<Options>::Row range_min_row() {
  return {"range_min", [](auto& of) -> decltype(auto) { return (of.range.min); }, "m",
          "what is nearer is shown as -infinity", 0};
}
/// The same.
template <class Options>
[[nodiscard]] typename OptionTable<Options>::Row range_max_row() {
  return {"range_max", [](auto& of) -> decltype(auto) { return (of.range.max); }, "m",
          "what is farther is shown as +infinity", 0};
}

}  // namespace murosimf::sensors
