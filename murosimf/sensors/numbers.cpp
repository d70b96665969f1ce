#include "murosimf/sensors/numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::sensors {

double checked_number(const SensorSpec& spec, const std::string& key, double otherwise, const NumberBounds& bounds) {
  const double number = spec.number(key, otherwise);
  if (number >= bounds.lowest && number <= bounds.highest) return number;
  const bool open = std::isinf(bounds.highest);
  throw SetupError(fmt::format("{} is {}; it must be from {:.6g} {}", key, number, bounds.lowest,
                               open ? "on" : fmt::format("to {:.6g}", bounds.highest)));
}

double checked_positive(const SensorSpec& spec, const std::string& key, double otherwise) {
  const double number = spec.number(key, otherwise);
  if (number > 0 && std::isfinite(number)) return number;
  throw SetupError(fmt::format("{} is {}; it must be positive", key, number));
}

int checked_count(const SensorSpec& spec, const std::string& key, int otherwise, const NumberBounds& bounds) {
  const double number = checked_number(spec, key, otherwise, bounds);
  if (number == std::floor(number)) return static_cast<int>(number);
  throw SetupError(fmt::format("{} is {}; it must be a whole number", key, number));
}

double checked_fov(const SensorSpec& spec, const std::string& key, double otherwise, double most) {
  return std::min(checked_number(spec, key, otherwise, {0, most + 1e-4}), most);
}

Range checked_range(const SensorSpec& spec, const Range& otherwise) {
  const Range range{checked_number(spec, "range_min", otherwise.min), checked_number(spec, "range_max", otherwise.max)};
  if (range.min < range.max) return range;
  throw SetupError(fmt::format("range_min is {} and range_max {}: nothing is between them", range.min, range.max));
}

}  // namespace murosimf::sensors
