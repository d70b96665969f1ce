/// numbers.h - numbers of a sensor that only its type has (SensorSpec::numbers), checked.
#pragma once

#include <limits>
#include <string>

#include "murosimf/math/scalar.h"
#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::sensors {

/// What a number may be, ends included.
struct NumberBounds {
  double lowest = 0, highest = std::numeric_limits<double>::infinity();
};

/// The number called `key`, or `otherwise`. Throws SetupError that names the key if it is not within the bounds.
[[nodiscard]] double checked_number(const SensorSpec& spec, const std::string& key, double otherwise,
                                    const NumberBounds& bounds = {});
/// The same for a finite number above 0.
[[nodiscard]] double checked_positive(const SensorSpec& spec, const std::string& key, double otherwise);
/// The same for a whole number.
[[nodiscard]] int checked_count(const SensorSpec& spec, const std::string& key, int otherwise,
                                const NumberBounds& bounds);

/// The same for an angle [rad] from side to side, from 0 to `most`. Rounded ones, like 3.1416 to both sides, count as it.
[[nodiscard]] double checked_fov(const SensorSpec& spec, const std::string& key, double otherwise,
                                 double most = 2 * pi);

/// Between which distances [m] a sensor sees something.
struct Range {
  double min = 0, max = std::numeric_limits<double>::infinity();

  /// A distance as it is shown: -infinity if it is too small, +infinity if it is too big or there is nothing (REP-117).
  [[nodiscard]] double shown(double distance) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return distance < min ? -infinity : distance > max ? infinity : distance;
  }
};

/// The numbers range_min and range_max. Throws SetupError if nothing is between them.
[[nodiscard]] Range checked_range(const SensorSpec& spec, const Range& otherwise);

}  // namespace murosimf::sensors
