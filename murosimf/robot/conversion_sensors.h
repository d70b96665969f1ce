/// conversion_sensors.h - sensors of URDF as MJCF has them, for programs that read the MJCF file alone.
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// An inertial sensor becomes a site `NAME_site` with `gyro`, `accelerometer` and `framequat`, a camera a `camera` of its name; noise and rates MJCF
/// has no words for. Returns names of sensors that are read of the new file and double one of the TOML file, which has to remove them. `whole`:
/// the same robot with sensors in the same order, whose `becomes` is known.
[[nodiscard]] std::vector<std::string> give_mjcf_sensors(robot_formats::RobotDescription& description,
                                                         const robot_formats::RobotDescription& whole);

}  // namespace murosimf::robot
