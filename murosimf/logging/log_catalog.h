/// log_catalog.h - every number of a simulation that can be logged, with name and unit.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/logging/log_paths.h"

namespace murosimf::logging {

/// Numbers of all sensors.
[[nodiscard]] std::vector<LoggedNumber> numbers_of_sensors(Entity& entity);

/// Numbers of all changing properties, of all objects, by each name of these. Properties of joints exist for
/// joints only.
[[nodiscard]] std::vector<LoggedNumber> numbers_of_properties(Entity& entity);

/// The parts of a path between its dots.
[[nodiscard]] std::vector<std::string> path_parts(std::string_view path);

/// The unit of one of several numbers: "m/s" applies to all, "m/s, m/s, rad/s" lists them one by one, "N m, N" are those of the
/// first and the second half; "rad | m" is for revolute and prismatic joints.
[[nodiscard]] std::string unit_of(std::string_view units, std::size_t index, std::size_t numbers,
                                  bool prismatic = false);

}  // namespace murosimf::logging
