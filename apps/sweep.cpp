// `murosimf sweep`: a scene for many seeds and values, in parallel.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/record_options.h"
#include "apps/results.h"
#include "apps/series_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/studies/sweep.h"

namespace murosimf::app {
namespace {

struct SweepArguments {
  SeriesArguments runs;
  std::string seeds;
  std::vector<std::string> grid, results;
  std::string noted, csv, summary;  ///< files
};

void define(const Command& command, SweepArguments& arguments) {
  SceneArguments& scene = arguments.runs.scene;
  add_scene_file(command, scene.file);
  command.add("--seeds", arguments.seeds, "Seeds, like 1..20 or 3,5,8; the scene's if not given");
  command
      .add("--grid", arguments.grid,
           "PATH=A,B,C: values that something of the scene takes, like 'walker.command.0=0.1,0.2'; several: all "
           "combinations")
      .one_at_a_time();
  add_series(command, arguments.runs);
  command
      .add("--result", arguments.results,
           "A number at the end, like 'walker.distance', or as --log names it, like 'ball.ball.position'")
      .one_at_a_time();
  command.add("--at", scene.events, "TIME:PATH=VALUE: change it while it runs").one_at_a_time();
  command.add("--push", scene.pushes, "OBJECT=FORCE@BEGIN..END: push a body").one_at_a_time();
  command.add("--runs", arguments.noted,
              "Note each run in this file when it is done; a sweep that was ended goes on with what is in it");
  command.add("--csv", arguments.csv, "Write a table of all runs to this file (CSV)");
  command.add("--summary", arguments.summary, "Write means and intervals to this file (CSV), for 'plot'");
  add_series_end(command, arguments.runs);
}

studies::SweepOptions options_of(const SweepArguments& arguments) {
  studies::SweepOptions options{.scene = arguments.runs.scene.file,
                                .duration = arguments.runs.duration,
                                .results = arguments.results};
  for (const std::string& axis : arguments.grid) options.axes.push_back(studies::parse_axis(axis));
  if (!arguments.seeds.empty()) options.seeds = studies::parse_seeds(arguments.seeds);
  options.common = options_of(arguments.runs);
  options.file = arguments.noted;
  options.program = this_program();
  return options;
}

void check(const SweepArguments& arguments) {
  check_json_file(arguments.runs.json);
  if (!arguments.csv.empty()) files::claim_output("--csv", arguments.csv);
  if (!arguments.summary.empty()) files::claim_output("--summary", arguments.summary);
  if (!arguments.noted.empty()) files::claim_continued("--runs", arguments.noted);
  const std::optional<double> duration = arguments.runs.duration;
  if (!duration || (*duration >= 0 && *duration <= scene_file::longest_duration)) return;
  throw SetupError(fmt::format("--duration {}: must be a number from 0", *duration));
}

int sweep(const SweepArguments& arguments) {
  check(arguments);
  studies::SweepOptions options = options_of(arguments);
  end_gently();
  std::optional<Progress> progress(std::in_place);
  options.progress = [&](std::size_t done, std::size_t all) {
    progress->show(static_cast<double>(done) / static_cast<double>(all), fmt::format("{} of {} runs", done, all));
  };
  const studies::Sweep result = studies::sweep(options);
  progress.reset();
  if (result.taken_over > 0) say_note(fmt::format("{} runs were in '{}' already", result.taken_over, arguments.noted));
  Results results;
  results.write([&] { write_result(arguments.runs.json, to_text(result), to_json(result)); });
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
