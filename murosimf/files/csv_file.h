/// csv_file.h - reads a table of numbers over time, separated by commas, semicolons or tabs, with a header: those of --log, and others.
///
/// RFC 4180: cells may be in quotes, lines may end with CR LF. The first column is the time. A cell may be empty: that
/// column has nothing at that time. nan and inf are numbers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace murosimf::files {

struct CsvColumn {
  std::string name;                   ///< "blue1.imu.gyroscope.x", without the unit
  std::string unit;                   ///< "rad/s" of "name [rad/s]"; empty: it has none
  std::vector<double> times, values;  ///< of the cells that are not empty
};

struct CsvTable {
  std::string time;                ///< name of the first column, with unit
  std::vector<CsvColumn> columns;  ///< the others
};

/// Throws SetupError with file:line:column: no such file, no header, a cell that is no number, a line with more or less
/// cells than the header, a time that is missing or not finite.
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& file);

}  // namespace murosimf::files
