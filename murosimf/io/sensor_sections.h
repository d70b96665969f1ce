/// sensor_sections.h - sensors as sections of the TOML file beside a robot.
#pragma once

#include <string>
#include <vector>

#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::io {

/// A section [sensors.NAME] for each, complete: numbers of parts are written down.
[[nodiscard]] std::string sensor_sections(const std::vector<sensors::SensorSpec>& sensors);

}  // namespace murosimf::io
