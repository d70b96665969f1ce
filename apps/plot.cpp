// `murosimf plot`: draws a table of numbers over time.
#include <filesystem>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/results.h"
#include "murosimf/files/csv_file.h"
#include "murosimf/logging/log_npy.h"
#include "murosimf/logging/log_plot.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/recorded_series.h"

namespace murosimf::app {
namespace {

struct PlotOptions {
  std::string file;                   ///< CSV or MCAP
  std::string out;                    ///< PNG file; empty: beside the table
  std::vector<std::string> patterns;  ///< columns to draw; none: all
};

void define(const Command& command, PlotOptions& options) {
  command.add("file", options.file, "Table (CSV) with a header and the time in its first column, or a recording (MCAP)")
      .required();
  command.add("patterns", options.patterns, "Columns to draw, like 'blue1.imu.*'; all if not given");
  command.add("--out", options.out, "PNG file to write, instead of one beside the table");
}

/// Of a recording: what the patterns mean.
files::CsvTable table_in(const std::filesystem::path& file, const std::vector<std::string>& patterns) {
  if (logging::is_named_npy(file)) {
    throw SetupError(
        fmt::format("'{}' is an array for NumPy, which is not drawn here; write a log as CSV, or draw the recording",
                    file.string()));
  }
  if (!recording::is_recording(file)) return files::read_csv(file);
  return recording::table_of(recording::series_of(recording::McapReader(file), patterns));
}

int plot(const PlotOptions& options) {
  namespace fs = std::filesystem;
  const fs::path file = options.file;
  const fs::path picture = options.out.empty() ? fs::path(file).replace_extension(".png") : fs::path(options.out);
  const files::CsvTable table = table_in(file, options.patterns);
  claim_picture("--out", picture.string());
  logging::write_plot(picture, with_context(options.file, [&] {
                        return logging::plot_of(table, file.filename().string(), options.patterns);
                      }));
  return 0;
}

}  // namespace

void add_plot(CommandLine& line) {
  line.add<PlotOptions>("plot", "Draw numbers over time: what 'run --log' wrote, or any such table", define, plot);
}

}  // namespace murosimf::app
