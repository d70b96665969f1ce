/// servo_table.h - ready-made servos: the files `servos/<type>.toml` (docs/robots.md, "Servos").
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/model/servo.h"

namespace murosimf::component_files {

/// The servo of type `type`, for example "mx64", or the one in a file of that path. Throws SetupError.
[[nodiscard]] Servo read_servo(std::string_view type);

/// All types that come with the program, in alphabetical order.
[[nodiscard]] std::vector<std::string> servo_types();

}  // namespace murosimf::component_files
