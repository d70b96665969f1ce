/// log_csv.h - numbers recorded during a run, and their table of comma-separated values (CSV).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "murosimf/world/time.h"

namespace murosimf::logging {

/// Rows of numbers with their instants.
struct LogSeries {
  std::vector<std::string> names;  ///< of the columns, with unit: "blue1.imu.gyroscope.x [rad/s]"
  std::vector<Duration> times;     ///< of the rows, ascending
  std::vector<double> values;      ///< row by row
};

/// One table by RFC 4180 (with "\n" at the ends of lines): a header, `time [s]` and the columns of all series in their
/// order, and one row for each instant of any of them, ordered by time. A cell is empty where a series has no row at that
/// instant. Numbers have the fewest digits that reproduce the same double; others are nan, inf, -inf.
[[nodiscard]] std::string to_csv(const std::vector<const LogSeries*>& series);

}  // namespace murosimf::logging
