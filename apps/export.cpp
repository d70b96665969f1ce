// `murosimf export`: numbers of a recording as a table, a robot's motion, or a bag of ROS 2.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/logging/log_csv.h"
#include "murosimf/logging/log_npy.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/bvh_export.h"
#include "murosimf/recording/recorded_series.h"
#include "murosimf/recording/rosbag2/rosbag2_export.h"

namespace murosimf::app {
namespace {

struct ExportOptions {
  std::string file;                   ///< MCAP
  std::vector<std::string> patterns;  ///< numbers; none: all
  std::string csv, npy, bvh;          ///< files to write
  std::string rosbag2;                ///< folder to write
  std::string robot;                  ///< of the motion
};

void define(const Command& command, ExportOptions& options) {
  command.add("file", options.file, "Recording (MCAP) of 'murosimf run --record'").required();
  command.add("patterns", options.patterns, "Numbers, like 'blue1.*.joint_position'; all if not given");
  const Option csv = command.add("--csv", options.csv, "Table to write (CSV), as 'run --log' does");
  const Option npy = command.add("--npy", options.npy, "Array to write for NumPy, with a named field for each number");
  const Option bvh = command.add("--bvh", options.bvh, "Motion of a robot to write (BVH), for Blender");
  npy.excludes(csv);
  const Option rosbag2 =
      command.add("--rosbag2", options.rosbag2, "Bag of ROS 2 to write, a new folder: metadata.yaml and MCAP");
  bvh.excludes(csv).excludes(npy);
  rosbag2.excludes(csv).excludes(npy).excludes(bvh);
  command.add("--robot", options.robot, "Whose motion; not needed where only one has joints").needs(bvh);
}

int export_motion(const recording::McapReader& file, const ExportOptions& options) {
  if (!options.patterns.empty())
    throw SetupError("--bvh writes the motion of all joints: it takes no names of numbers");
  files::write_file(options.bvh, recording::bvh_of(file, options.robot));
  return 0;
}

int export_bag(const recording::McapReader& file, const ExportOptions& options) {
  if (!options.patterns.empty())
    throw SetupError("--rosbag2 writes all that ROS 2 has messages for: it takes no names of numbers");
  std::vector<std::string> missing;
  const auto descriptions = recording::recorded_descriptions(options.file, missing);
  for (const std::string& line : missing) say_warning(line);
  const recording::Rosbag2Summary bag = recording::write_rosbag2(file, options.rosbag2, descriptions);
  fmt::print("{}: {} messages of {} topics\n", options.rosbag2, bag.messages, bag.topics);
  return 0;
}

int export_recording(const ExportOptions& options) {
  const std::string out = options.csv + options.npy + options.bvh;  // only one
  if (out.empty() && options.rosbag2.empty()) {
    throw SetupError(
        "say where it goes: --csv FILE.csv or --npy FILE.npy for numbers, --bvh FILE.bvh for a motion, --rosbag2 "
        "FOLDER for a bag of ROS 2");
  }
  if (!out.empty()) files::claim_output(options.csv.empty() ? options.npy.empty() ? "--bvh" : "--npy" : "--csv", out);
  const recording::McapReader file(options.file);
  if (!file.contents().damage.empty()) say_warning(fmt::format("{}: {}", options.file, file.contents().damage));
  if (!options.bvh.empty()) return export_motion(file, options);
  if (!options.rosbag2.empty()) return export_bag(file, options);
  const std::vector<logging::LogSeries> series = recording::series_of(file, options.patterns);
  std::vector<const logging::LogSeries*> all;
  for (const logging::LogSeries& one : series) all.push_back(&one);
  files::write_file(out, options.npy.empty() ? logging::to_csv(all) : logging::to_npy(all));
  return 0;
}

}  // namespace

void add_export(CommandLine& line) {
  line.add<ExportOptions>("export", "Write numbers of a recording as a table, the motion of a robot, or a bag of ROS 2",
                          define, export_recording);
}

}  // namespace murosimf::app
