/// trajectory_columns.h - the first line of a table of joint angles: joint and unit of each column.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "murosimf/files/csv_cells.h"
#include "murosimf/model/model.h"

namespace murosimf::control_software {

/// Selects columns of a log: ENTITY.JOINT.PROPERTY. Those of other properties and of other entities are ignored.
struct LogColumns {
  std::string property = "joint_target";
  std::string entity;
  bool no_other = false;  ///< else, if the log has none of that entity, those of the only other one
};

struct TrajectoryColumns {
  struct Column {
    std::size_t cell = 0;    ///< of a line
    int object = 0;          ///< the joint
    double factor = 1;       ///< to rad or m
    double lowest, highest;  ///< [rad | m] values beyond are errors
  };
  std::size_t cells = 0;   ///< of every line
  double time_factor = 1;  ///< to s
  std::vector<Column> columns;
};

/// Throws SetupError, with the place in the file, as read_trajectory (trajectory_file.h) says.
[[nodiscard]] TrajectoryColumns trajectory_columns(const files::CsvCells& cells,
                                                   const std::vector<files::CsvCell>& line, const Model& model,
                                                   const LogColumns& log);

}  // namespace murosimf::control_software
