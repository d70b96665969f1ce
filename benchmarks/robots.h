/// robots.h - the robot that all benchmarks use.
#pragma once

#include "murosimf/files/data_path.h"
#include "murosimf/robot/robot_reader.h"

namespace murosimf::benchmarks {

inline ModelPtr kid21() {
  static const ModelPtr model = robot::read_robot(files::find_data_file("kid21", "models", ".xml")).model;
  return model;
}

}  // namespace murosimf::benchmarks
