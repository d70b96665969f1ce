// `murosimf branch`: several continuations of one moment of a recorded run.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/repeat_arguments.h"
#include "apps/results.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/studies/branches.h"

namespace murosimf::app {
namespace {

struct BranchArguments {
  std::string file;  ///< MCAP
  RepeatArguments how;
  std::optional<double> time, duration;  ///< [s]
  std::vector<std::string> changes, results;
  std::string json, csv;  ///< files, "-" for standard output
};

void define(const Command& command, BranchArguments& arguments) {
  command.add("file", arguments.file, "State of 'run --save-at', or recording (MCAP)").required();
  command.add("--time", arguments.time,
              "Simulated seconds at which it branches, instead of the last state in the file");
  command
      .add("--set", arguments.changes,
           "PATH=VALUE: one branch with this change, as of --at; several changes with ';' between them")
      .one_at_a_time();
  command.add("--duration", arguments.duration, "Simulated seconds of each branch, instead of what is left of the run");
  command
      .add("--result", arguments.results,
           "A number at the end, like 'blue1.distance', or as --log names it, like 'ball.ball.position'")
      .one_at_a_time();
  command.add("--csv", arguments.csv, "Write the table to this file (CSV)");
  add_json(command, arguments.json);
  add_repeat(command, arguments.how);
}

std::optional<Duration> time_of(const char* option, const std::optional<double>& s) {
  if (!s) return std::nullopt;
  if (*s >= 0 && *s <= scene_file::longest_duration) return from_seconds(*s);
  throw SetupError(fmt::format("{} {}: must be a number from 0", option, *s));
}

int branch(const BranchArguments& arguments) {
  check_json_file(arguments.json);
  if (!arguments.csv.empty()) files::claim_output("--csv", arguments.csv);
  load_plugins(arguments.how.plugins);
  const recording::RecordedRun run(arguments.file);
  check_plugins(run, arguments.how);
  end_gently();
  const studies::Branches result = studies::branch(run, {.time = time_of("--time", arguments.time),
                                                         .duration = time_of("--duration", arguments.duration),
                                                         .changes = arguments.changes,
                                                         .results = arguments.results,
                                                         .repeat = options_of(arguments.how)});
  Results results;
  results.write([&] { write_result(arguments.json, to_text(result), to_json(result)); });
  if (!arguments.csv.empty()) results.write([&] { files::write_file(arguments.csv, to_csv(result)); });
  if (result.stopped) say_error(fmt::format("stopped by {}; branches that had not ended are missing", signal_name()));
  return results.exit_code(result.stopped ? exit_code() : 0);
}

}  // namespace

void add_branch(CommandLine& line) {
  line.add<BranchArguments>("branch", "Go on from a state or recording in several ways, and compare the ends", define,
                            branch);
}

}  // namespace murosimf::app
