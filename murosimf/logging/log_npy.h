/// log_npy.h - numbers recorded during a run as a file of NumPy (NPY): the table of log_csv.h, in binary.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/logging/log_csv.h"

namespace murosimf::logging {

/// An array of rows by time with named fields of doubles, `time [s]` and the columns of all series in their order; NaN where a series has
/// no row at that instant. numpy.load(file)["blue1.imu.gyroscope.x [rad/s]"]
[[nodiscard]] std::string to_npy(const std::vector<const LogSeries*>& series);

/// Whether the name has the extension of such files.
[[nodiscard]] bool is_named_npy(const std::filesystem::path& file);

}  // namespace murosimf::logging
