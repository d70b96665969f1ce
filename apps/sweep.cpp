// `murosimf sweep`: a scene for many seeds and values, in parallel.
#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/interruption.h"
#include "apps/last_words.h"
#include "apps/progress.h"
#include "apps/record_options.h"
#include "apps/results.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/series/sweep.h"

namespace murosimf::app {
namespace {

struct SweepArguments {
  std::string file;  ///< scene
  std::string seeds;
  std::vector<std::string> grid, results, overrides, events, pushes, plugins;
  std::optional<double> duration;  ///< [s]
  int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
  bool no_cameras = false, lenient = false, libraries = false;
  std::string runs, csv, summary, json;  ///< files
};

void define(const Command& command, SweepArguments& arguments) {
  add_scene_file(command, arguments.file);
  command.add("--seeds", arguments.seeds, "Seeds, like 1..20 or 3,5,8; the scene's if not given");
  command
      .add("--grid", arguments.grid,
           "PATH=A,B,C: values that something of the scene takes, like 'walker.command.0=0.1,0.2'; several: all "
           "combinations")
      .one_at_a_time();
  command.add("--duration", arguments.duration, "Simulated seconds of each run, instead of the scene's");
  command
      .add("--result", arguments.results,
           "A number at the end, like 'walker.distance', or as --log names it, like 'ball.ball.position'")
      .one_at_a_time();
  command.add("--set", arguments.overrides, "PATH=VALUE: change the scene of all runs").one_at_a_time();
  command.add("--at", arguments.events, "TIME:PATH=VALUE: change it while it runs").one_at_a_time();
  command.add("--push", arguments.pushes, "OBJECT=FORCE@BEGIN..END: push a body").one_at_a_time();
  command.add("--threads", arguments.threads, "Runs at a time; as many as the machine has processors if not given")
      .within(1, 256);
  command.add("--no-cameras", arguments.no_cameras, "Draw nothing for cameras: they have no frames then");
  command.add("--runs", arguments.runs,
              "Note each run in this file when it is done; a sweep that was ended goes on with what is in it");
  command.add("--csv", arguments.csv, "Write a table of all runs to this file (CSV)");
  command.add("--summary", arguments.summary, "Write means and intervals to this file (CSV), for 'plot'");
  add_json(command, arguments.json);
  add_lenient(command, arguments.lenient);
  add_plugins(command, arguments.plugins);
  command.add(
      "--libraries", arguments.libraries,
      "Load the control software that the scene file names (controller = \"library\"): it may do what it likes");
}

series::SweepOptions options_of(const SweepArguments& arguments) {
  series::SweepOptions options{.scene = arguments.file, .duration = arguments.duration, .results = arguments.results};
  for (const std::string& axis : arguments.grid) options.axes.push_back(series::parse_axis(axis));
  if (!arguments.seeds.empty()) options.seeds = series::parse_seeds(arguments.seeds);
  options.common.threads = arguments.threads;
  options.common.overrides = arguments.overrides;
  options.common.events = arguments.events;
  options.common.pushes = arguments.pushes;
  options.common.lenient = arguments.lenient;
  options.common.libraries = arguments.libraries;
  options.common.cameras = !arguments.no_cameras;
  options.common.stop = interrupted;
  options.file = arguments.runs;
  options.program = this_program();
  return options;
}

void check(const SweepArguments& arguments) {
  check_json_file(arguments.json);
  if (!arguments.csv.empty()) files::claim_output("--csv", arguments.csv);
  if (!arguments.summary.empty()) files::claim_output("--summary", arguments.summary);
  if (!arguments.runs.empty()) files::claim_continued("--runs", arguments.runs);
  if (!arguments.duration) return;
  if (*arguments.duration >= 0 && *arguments.duration <= scene_file::longest_duration) return;
  throw SetupError(fmt::format("--duration {}: must be a number from 0", *arguments.duration));
}

int sweep(const SweepArguments& arguments) {
  check(arguments);
  series::SweepOptions options = options_of(arguments);
  load_plugins(arguments.plugins);
  end_gently();
  std::optional<Progress> progress(std::in_place);
  options.progress = [&](std::size_t done, std::size_t all) {
    progress->show(static_cast<double>(done) / static_cast<double>(all), fmt::format("{} of {} runs", done, all));
  };
  const series::Sweep result = series::sweep(options);
  progress.reset();
  if (result.taken_over > 0) say_note(fmt::format("{} runs were in '{}' already", result.taken_over, arguments.runs));
  Results results;
  results.write([&] { write_result(arguments.json, to_text(result), to_json(result)); });
  if (!arguments.csv.empty()) results.write([&] { files::write_file(arguments.csv, to_csv(result)); });
  if (!arguments.summary.empty()) results.write([&] { files::write_file(arguments.summary, summary_csv(result)); });
  if (!result.not_noted.empty()) results.write([&] { throw SetupError(result.not_noted); });
  if (result.stopped) say_error(fmt::format("stopped by {}; runs that had not ended are missing", signal_name()));
  return results.exit_code(result.stopped ? exit_code() : 0);
}

}  // namespace

void add_sweep(CommandLine& line) {
  line.add<SweepArguments>("sweep", "Run a scene for many seeds and values, and show what comes out", define, sweep);
}

}  // namespace murosimf::app
