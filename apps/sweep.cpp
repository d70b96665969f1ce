// `murosimf sweep`: a scene for many seeds and values, in parallel.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/record_options.h"
#include "apps/results.h"
#include "apps/sweep_arguments.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/model/error.h"
#include "murosimf/studies/sweep_manifest.h"

namespace murosimf::app {
namespace {

void define(const Command& command, SweepArguments& arguments) {
  SceneArguments& scene = arguments.runs.scene;
  add_scene_file(command, scene.file,
                 "Scene file (TOML), the name of one that comes with the program, or a manifest (JSON)");
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
  command.add("--manifest", arguments.manifest,
              "Write all runs to this file (JSON) and run nothing; 'sweep FILE' runs them, here or in shards anywhere");
  command.add("--shard", arguments.shard,
              "Of a manifest: K/N does each N-th run from the K-th on, any/N shards that no process works on");
  command.add("--merge", arguments.merge, "Of a manifest: run nothing, make the tables of what is done");
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
  claim_tables(arguments);
  if (!arguments.noted.empty()) files::claim_continued("--runs", arguments.noted);
  if (!arguments.manifest.empty()) {
    if (!arguments.manifest.ends_with(manifest_ending)) {
      throw SetupError(fmt::format("--manifest '{}': its name must end in {}", arguments.manifest, manifest_ending));
    }
    files::claim_continued("--manifest", arguments.manifest);
  }
  const std::optional<double> duration = arguments.runs.duration;
  if (!duration || (*duration >= 0 && *duration <= scene_file::longest_duration)) return;
  throw SetupError(fmt::format("--duration {}: must be a number from 0", *duration));
}

int sweep(const SweepArguments& arguments) {
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
  write_tables(results, arguments, result);
  if (!result.not_noted.empty()) results.write([&] { throw SetupError(result.not_noted); });
  if (result.stopped) say_error(fmt::format("stopped by {}; runs that had not ended are missing", signal_name()));
  return results.exit_code(result.stopped ? exit_code() : 0);
}

int begin(const SweepArguments& arguments) {
  if (is_manifest(arguments)) return sweep_manifest(arguments);
  if (!arguments.shard.empty() || arguments.merge) {
    throw SetupError(fmt::format("{}: shards are parts of a manifest; 'sweep SCENE --manifest FILE' writes one",
                                 arguments.merge ? "--merge" : "--shard"));
  }
  check(arguments);
  if (arguments.manifest.empty()) return sweep(arguments);
  studies::write_manifest(arguments.manifest, options_of(arguments));
  return 0;
}

}  // namespace

void add_sweep(CommandLine& line) {
  line.add<SweepArguments>("sweep", "Run a scene for many seeds and values, and show what comes out", define, begin);
}

}  // namespace murosimf::app
