// `murosimf export`: numbers of a recording as a table, or a robot's motion.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/logging/log_csv.h"
#include "murosimf/logging/log_npy.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/bvh_export.h"
#include "murosimf/recording/recorded_series.h"

namespace murosimf::app {
namespace {

struct ExportOptions {
  std::string file;                   ///< MCAP
  std::vector<std::string> patterns;  ///< numbers; none: all
  std::string csv, npy, bvh;          ///< files to write
  std::string robot;                  ///< of the motion
};

void define(const Command& command, ExportOptions& options) {
  command.add("file", options.file, "Recording (MCAP) of 'murosimf run --record'").required();
  command.add("patterns", options.patterns, "Numbers, like 'blue1.*.joint_position'; all if not given");
  const Option csv = command.add("--csv", options.csv, "Table to write (CSV), as 'run --log' does");
  const Option npy = command.add("--npy", options.npy, "Array to write for NumPy, with a named field for each number");
  const Option bvh = command.add("--bvh", options.bvh, "Motion of a robot to write (BVH), for Blender");
  npy.excludes(csv);
  bvh.excludes(csv).excludes(npy);
  command.add("--robot", options.robot, "Whose motion; not needed where only one has joints").needs(bvh);
}

int export_motion(const recording::McapReader& file, const ExportOptions& options) {
  if (!options.patterns.empty())
    throw SetupError("--bvh writes the motion of all joints: it takes no names of numbers");
  files::write_file(options.bvh, recording::bvh_of(file, options.robot));
  return 0;
}

int export_recording(const ExportOptions& options) {
  const std::string out = options.csv + options.npy + options.bvh;  // only one
  if (out.empty()) {
    throw SetupError("say where it goes: --csv FILE.csv or --npy FILE.npy for numbers, or --bvh FILE.bvh for a motion");
  }
  files::claim_output(options.csv.empty() ? options.npy.empty() ? "--bvh" : "--npy" : "--csv", out);
  const recording::McapReader file(options.file);
  if (!file.contents().damage.empty()) say_warning(fmt::format("{}: {}", options.file, file.contents().damage));
  if (!options.bvh.empty()) return export_motion(file, options);
  const std::vector<logging::LogSeries> series = recording::series_of(file, options.patterns);
  std::vector<const logging::LogSeries*> all;
  for (const logging::LogSeries& one : series) all.push_back(&one);
  files::write_file(out, options.npy.empty() ? logging::to_csv(all) : logging::to_npy(all));
  return 0;
}

}  // namespace

void add_export(CommandLine& line) {
  line.add<ExportOptions>("export", "Write numbers of a recording as a table, or the motion of a robot", define,
                          export_recording);
}

}  // namespace murosimf::app
