/// recorded_series.h - numbers of a recording as tables, by their names in logs (logging/log_paths.h).
///
///     blue1.j_l_foot.position.x [m]       of each link's frame, world
///     blue1.j_l_shin.joint_position [rad]  and joint_velocity, joint_torque, joint_target
///     blue1.imu.gyroscope.x [rad/s]        of sensors, if recorded
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/files/csv_file.h"
#include "murosimf/logging/log_csv.h"
#include "murosimf/recording/mcap/mcap_reader.h"

namespace murosimf::recording {

/// Whether a file begins like a recording.
[[nodiscard]] bool is_recording(const std::filesystem::path& file);

/// One number each, in the order of the patterns that denote them, as for logging::plot_of, and then of their first appearance; all, if there are no patterns.
/// Throws SetupError for a pattern without a number, and for a file that is damaged or no recording of this program.
[[nodiscard]] std::vector<logging::LogSeries> series_of(const McapReader& recording,
                                                        const std::vector<std::string>& patterns = {});

/// As a table for plots.
[[nodiscard]] files::CsvTable table_of(const std::vector<logging::LogSeries>& series);

}  // namespace murosimf::recording
