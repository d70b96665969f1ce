/// log_plot.h - a table of numbers over time as a picture: one panel for all numbers of one sensor with the same unit.
///
/// Names with four parts or more ("blue1.imu.gyroscope.x") belong to the sensor or object of the first two; with three
/// ("blue1.left_knee.joint_position") those of all objects of a robot share a panel; all others are grouped by unit.
#pragma once

#include <string>
#include <vector>

#include "murosimf/files/csv_file.h"
#include "murosimf/logging/plot.h"

namespace murosimf::logging {

/// The columns with names that match one of the patterns (as in log_paths.h: * and ? within a part, a missing rest matches all
/// below); all, if there are no patterns. Throws SetupError: a pattern without a column, with the nearest name; more
/// curves in a panel, or panels, than can be distinguished.
[[nodiscard]] Plot plot_of(const files::CsvTable& table, const std::string& title,
                           const std::vector<std::string>& patterns = {});

/// Whether a pattern of plot_of() denotes the number of this name, without unit.
[[nodiscard]] bool matches_name(const std::string& pattern, const std::string& name);

}  // namespace murosimf::logging
