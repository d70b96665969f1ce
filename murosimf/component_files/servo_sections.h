/// servo_sections.h - the servos of a robot as sections of the TOML file beside it.
#pragma once

#include <string>
#include <string_view>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::component_files {

/// Servo::type of servos with guessed gains (role_inference.h).
inline constexpr const char* guessed_servo = "guessed";

/// Text in quotes, escaped for TOML.
[[nodiscard]] std::string toml_quoted(const std::string& text);

/// A section [servos.NAME] for each kind of drive, with its joints: law ideal_pd, with the numbers of actuator
/// and joint, because such a servo stands for both. Guessed gains have a comment. Joints without a drive, or
/// that follow others, have none. NAME is `name` and a number.
[[nodiscard]] std::string servo_sections(const robot_formats::RobotDescription& description,
                                         std::string_view name = "servo");

}  // namespace murosimf::component_files
