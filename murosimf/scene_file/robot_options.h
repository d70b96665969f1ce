/// robot_options.h - [robots.options] of a scene file: the options that the controller of a robot has of its own.
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <vector>

#include <toml++/toml.h>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// Into `robot.options`. Throws SetupError with file:line:column: a key that its controller does not have, with the nearest; a
/// value of another type or out of range.
void read_options(const toml::table& node, RobotSpec& robot);

/// Of [defaults.options] those that the robot's controller has; the others are for other robots. Throws SetupError for values.
void read_default_options(const toml::table& node, RobotSpec& robot);

/// Throws SetupError for a key of [defaults.options] that the controller of none of the robots has.
void check_default_options(const toml::table& node, const std::vector<RobotSpec>& robots);

}  // namespace murosimf::scene_file
