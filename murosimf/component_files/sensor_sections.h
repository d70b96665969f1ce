/// sensor_sections.h - sensors as sections of the TOML file beside a robot.
#pragma once

#include <string>
#include <vector>

#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::component_files {

/// A section [sensors.NAME] for each. Numbers of a part are written as the sensor's own, for all of its outputs.
[[nodiscard]] std::string sensor_sections(const std::vector<sensors::SensorSpec>& sensors);

}  // namespace murosimf::component_files
