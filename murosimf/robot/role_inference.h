/// role_inference.h - guesses from the robot what its file and the table beside it do not have: soles, frames of camera
/// and inertial sensor, hands, and servos of joints with only a largest torque.
///
/// Every guess is a line in the description's notes, and can be written as a table to be corrected (roles_toml).
#pragma once

#include <string>

#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Gives every sole of the table a frame with a rectangle: a foot, or a frame without a box, gets one under the shapes of
/// its body. Throws SetupError, at the table's line, if there is none. To be called after welding.
void place_soles(robot_formats::RobotDescription& description, RobotConfig& table);

/// Completes `table` and `description` where both have no data:
///   soles    frames called "...sole", else the two or four feet that the robot stands on in the pose of the file (robot_feet.h)
///   frames   imu, camera, left_hand, right_hand: by the names of frames, sensors and bodies; left is the one with that name
///   servos   servo_inference.h
void guess_roles(robot_formats::RobotDescription& description, RobotConfig& table);

/// Soles, frames and servos as the TOML file that belongs beside the robot.
[[nodiscard]] std::string roles_toml(const robot_formats::RobotDescription& description, const RobotConfig& table);

}  // namespace murosimf::robot
