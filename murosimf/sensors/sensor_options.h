/// sensor_options.h - options that only one type of sensor has, from what its spec gives (SensorSpec::numbers and texts).
///
///     const OptionTable<SonarOptions>& sonar_options();    // one row each: key, place, unit, meaning, range
///     const SonarOptions options = options_of(spec, sonar_options());
///
/// The same tables stand in the list of types (component_files/sensor_types.cpp), where files are checked against them.
#pragma once

#include <algorithm>

#include "murosimf/math/scalar.h"
#include "murosimf/model/option.h"
#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::sensors {

/// Those of `options` that the spec gives. Flags are numbers there: 0 is false.
[[nodiscard]] OptionValues given_options(const SensorSpec& spec, const std::vector<OptionInfo>& options);

/// Defaults, and what the spec gives. Throws SetupError that names the option that is impossible.
template <class Options>
[[nodiscard]] Options options_of(const SensorSpec& spec, const OptionTable<Options>& table) {
  Options options;
  table.apply(given_options(spec, table.infos()), options);
  return options;
}

constexpr double rounding = 1e-4;  ///< [rad] rounded angles, like 3.1416 to both sides, are meant as all round
constexpr double widest_fov = 2 * pi + rounding;  ///< [rad] from side to side
constexpr double most_rays = 100000;

}  // namespace murosimf::sensors
