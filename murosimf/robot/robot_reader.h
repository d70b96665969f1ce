/// robot_reader.h - a robot from its file, in any format of robot_formats.h, and the TOML file beside it, as a Model.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::robot {

struct RobotFile {
  ModelPtr model;
  std::vector<std::string>
      warnings;                    ///< one line each: file:line: what looks wrong, or is dropped because of `lenient`
  std::vector<std::string> notes;  ///< one line each: file:line: what has no effect here, what was guessed
  RobotConfig table;               ///< of the TOML file, completed by what was guessed (role_inference.h)
  std::vector<sensors::SensorSpec> sensors;     ///< that it carries
  robot_formats::RobotDescription description;  ///< what the model was made of; bodies without joints are welded
};

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] RobotFile read_robot(const std::filesystem::path& file, const robot_formats::ReaderOptions& options = {});

}  // namespace murosimf::robot
