// `murosimf export`: numbers of a recording as a table.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/last_words.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/recorded_series.h"

namespace murosimf::app {
namespace {

struct ExportOptions {
  std::string file;                   ///< MCAP
  std::vector<std::string> patterns;  ///< numbers; none: all
  std::string csv, npy;               ///< files to write
};

void define(const Command& command, ExportOptions& options) {
  command.add("file", options.file, "Recording (MCAP) of 'murosimf run --record'").required();
  command.add("patterns", options.patterns, "Numbers, like 'blue1.*.joint_position'; all if not given");
  const Option csv = command.add("--csv", options.csv, "Table to write (CSV), as 'run --log' does");
  command.add("--npy", options.npy, "Array to write for NumPy, with a named field for each number").excludes(csv);
}

int export_recording(const ExportOptions& options) {
  if (options.csv.empty() == options.npy.empty()) {
    throw SetupError("say where the numbers go: either --csv FILE.csv or --npy FILE.npy");
  }
  files::check_writable(options.csv.empty() ? options.npy : options.csv);
  const recording::McapReader file(options.file);
  if (!file.contents().damage.empty()) say_warning(fmt::format("{}: {}", options.file, file.contents().damage));
  const std::vector<logging::LogSeries> series = recording::series_of(file, options.patterns);
  if (!options.npy.empty()) {
    files::write_file(options.npy, recording::to_npy(series));
    return 0;
  }
  std::vector<const logging::LogSeries*> all;
  for (const logging::LogSeries& one : series) all.push_back(&one);
  files::write_file(options.csv, logging::to_csv(all));
  return 0;
}

}  // namespace

void add_export(CommandLine& line) {
  line.add<ExportOptions>("export", "Write numbers of a recording as a table", define, export_recording);
}

}  // namespace murosimf::app
