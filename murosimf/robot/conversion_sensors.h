/// conversion_sensors.h - sensors of URDF in the form of MJCF, for programs that read only the MJCF file.
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// An inertial sensor becomes a site `NAME_site` with `gyro`, `accelerometer` and `framequat`, a camera a `camera` of its name; MJCF
/// has no attributes for noise and rates. Returns the names of sensors that are read from the new file and double one of the TOML file,
/// which has to remove them. `whole`: the same robot with sensors in the same order, with `becomes` set.
[[nodiscard]] std::vector<std::string> give_mjcf_sensors(robot_formats::RobotDescription& description,
                                                         const robot_formats::RobotDescription& whole);

}  // namespace murosimf::robot
