/// table_files.h - the files that the TOML file beside a robot names: motions, the table of steps, servos, parts, lenses.
#pragma once

#include <filesystem>
#include <vector>

#include "murosimf/robot/robot_reader.h"

namespace murosimf::robot {

struct TableFiles {
  struct Beside {
    std::filesystem::path file;
    std::filesystem::path place;  ///< relative to the robot's folder: where a copy of the table finds it
  };
  std::vector<Beside> beside;
  std::vector<std::filesystem::path> elsewhere;  ///< in no folder of the robot, nor of the program
};

/// In the order in which they are read; what comes with the program is found from anywhere, and left out. `robot`: as it was read from `file`.
/// Throws SetupError as read_robot. A scope around it (files/file_access.h) does not note them.
[[nodiscard]] TableFiles table_files(const std::filesystem::path& file, const RobotFile& robot, bool lenient);

}  // namespace murosimf::robot
