/// sensor_cuts.h - cuts of a robot for the sensors that measure forces and moments inside it (sensors/joint_wrench.h).
#pragma once

#include <set>
#include <string>

#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Sets SensorDescription::behind of force_torque of URDF and of force and torque of MJCF: the body on which the sensor, its site or its
/// joint is. Returns all such bodies, also those of joint_wrench in the table: welding leaves them unchanged, and has to follow this.
[[nodiscard]] std::set<std::string> find_cuts(robot_formats::RobotDescription& description, const RobotConfig& table);

}  // namespace murosimf::robot
