/// robot_reader.h - reads a robot from its file, in any format of robot_formats.h, and the TOML file beside it, as a Model.
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
      warnings;  ///< one line each: file:line: a probable error, or a part that is dropped because of `lenient`
  std::vector<std::string> notes;               ///< one line each: file:line: a part without effect, or a guess
  RobotConfig table;                            ///< of the TOML file, completed by guesses (role_inference.h)
  std::vector<sensors::SensorSpec> sensors;     ///< of the robot
  robot_formats::RobotDescription description;  ///< of the model; bodies without joints are welded
};

/// Throws SetupError: file, line, error, correction.
[[nodiscard]] RobotFile read_robot(const std::filesystem::path& file, const robot_formats::ReaderOptions& options = {});

}  // namespace murosimf::robot
