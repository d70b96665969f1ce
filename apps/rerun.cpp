// `murosimf rerun`: repeats a recorded run and says where it first differs.
#include <cstdlib>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/record_options.h"
#include "apps/repeat_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/files/child_process.h"
#include "murosimf/recording/rerun.h"
#include "murosimf/scene/scene_report.h"

namespace murosimf::app {
namespace {

constexpr int difference_found = 1;  // exit code

struct RerunArguments {
  std::string file;     ///< MCAP
  RepeatArguments how;  ///< of the repetition
  std::string against;  ///< another program
  std::string json;     ///< file, "-" for standard output
  RecordOptions record;
};

void define(const Command& command, RerunArguments& arguments) {
  command.add("file", arguments.file, "Recording (MCAP) of 'murosimf run --record'").required();
  add_repeat(command, arguments.how);
  command.add("--against", arguments.against,
              "Another murosimf program: it repeats the run, too, and both are compared step by step");
  add_json(command, arguments.json);
  add_record(command, arguments.record);
}

/// `recorded` becomes false if the repetition is to be recorded and is not to its end, which is said.
recording::RerunResult repeat(const recording::RecordedRun& run, const RerunArguments& arguments,
                              const recording::RecordedStates* reference, bool& recorded) {
  Progress progress;
  const Duration begin = run.description().start, end = run.end();
  const bool records = !arguments.record.file.empty();
  std::unique_ptr<recording::Recorder> recorder;
  recording::RerunOptions options{.repeat = options_of(arguments.how), .reference = reference};
  options.repeat.recorded = records;
  options.to_the_end = records;
  options.progress = [&](Duration now) {
    const double all = seconds(end - begin);
    progress.show(all > 0 ? seconds(now - begin) / all : 1,
                  fmt::format("{:.1f} of {:.1f} s", seconds(now), seconds(end)));
  };
  options.prepare = [&](scene::Scene& scene) { recorder = make_recorder(scene, arguments.record, run); };
  options.finish = [&](scene::Scene& scene) {
    if (recorder) say_trouble(*recorder);
    if (recorder && !finish(*recorder, make_report(scene), arguments.record)) recorded = false;
    recorder.reset();
  };
  return recording::rerun(run, options);
}

/// Has the other program repeat the run; what it records of that.
recording::McapReader other_run(const RerunArguments& arguments, const std::filesystem::path& file,
                                const std::string& ticks) {
  std::vector<std::string> words{arguments.against, "rerun",         arguments.file, "--record",
                                 file.string(),     "--record-what", "hashes"};
  if (!ticks.empty()) words.insert(words.end(), {"--record-ticks", ticks});
  if (arguments.how.libraries) words.emplace_back("--libraries");
  const auto result = files::run_process(words, "");
  if (!result) throw SetupError(fmt::format("--against '{}': there is no such program", arguments.against));
  if (result->exit_code != 0 && result->exit_code != difference_found) {
    std::string line = result->errors.substr(0, result->errors.find('\n'));
    throw SetupError(fmt::format("--against '{}': it could not repeat the run: {}", arguments.against,
                                 line.empty() ? fmt::format("exit code {}", result->exit_code) : line));
  }
  return recording::McapReader(file);
}

/// First by the seconds, then by the steps of the second that differs.
recording::RerunResult compare_with_other(const recording::RecordedRun& run, const RerunArguments& arguments,
                                          bool& recorded) {
  const recording::ScratchFolder folder;
  const recording::McapReader seconds_file = other_run(arguments, folder.path() / "seconds.mcap", "");
  const recording::RecordedStates by_seconds(seconds_file);
  recording::RerunResult result = repeat(run, arguments, &by_seconds, recorded);
  if (!result.difference || result.stopped) return result;
  const Duration from = result.difference->same.value_or(run.description().start);
  const std::string ticks = fmt::format("{:.9f}..{:.9f}", seconds(from), seconds(result.difference->differs));
  const recording::McapReader ticks_file = other_run(arguments, folder.path() / "ticks.mcap", ticks);
  const recording::RecordedStates by_ticks(ticks_file);
  return repeat(run, arguments, &by_ticks, recorded);
}

int rerun(const RerunArguments& arguments) {
  check_json_file(arguments.json);
  check(arguments.record, false);
  load_plugins(arguments.how.plugins);
  const recording::RecordedRun run(arguments.file);
  if (const std::string& damage = run.file().contents().damage; !damage.empty()) {
    say_warning(fmt::format("{}: {}", arguments.file, damage));
  }
  check_plugins(run, arguments.how);
  end_gently();
  bool recorded = true;
  const recording::RerunResult result = arguments.against.empty() ? repeat(run, arguments, nullptr, recorded)
                                                                  : compare_with_other(run, arguments, recorded);
  write_result(arguments.json, to_text(result), to_json(result));
  if (!recorded) return user_error;
  if (result.difference) return difference_found;
  return result.stopped ? exit_code() : 0;
}

}  // namespace

void add_rerun(CommandLine& line) {
  line.add<RerunArguments>("rerun", "Repeat a recorded run and say where it first differs", define, rerun);
}

}  // namespace murosimf::app
