/// log_catalog.h - every number of a simulation that a log can hold, with name and unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/logging/log_paths.h"

namespace murosimf::logging {

/// Numbers of all sensors.
[[nodiscard]] std::vector<LoggedNumber> numbers_of_sensors(Entity& entity);

/// Numbers of all properties that change, of all objects, by each name that these have. What is of joints only is there for
/// joints only.
[[nodiscard]] std::vector<LoggedNumber> numbers_of_properties(Entity& entity);

/// The parts of a path between its dots.
[[nodiscard]] std::vector<std::string> path_parts(std::string_view path);

/// The unit of one number of several: "m/s" is that of all, "m/s, m/s, rad/s" has them one by one, "N m, N" are those of the
/// first and the last half; "rad | m" is of revolute joints and prismatic ones.
[[nodiscard]] std::string unit_of(std::string_view units, std::size_t index, std::size_t numbers,
                                  bool prismatic = false);

}  // namespace murosimf::logging
