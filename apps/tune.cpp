// `murosimf tune walk`: searches numbers of the walk for one robot.
#include <algorithm>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/interruption.h"
#include "apps/last_words.h"
#include "apps/progress.h"
#include "apps/results.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/series/walk_tuning.h"

namespace murosimf::app {
namespace {

struct TuneArguments {
  std::string what;
  std::string out;  ///< part of a robot's TOML file
  series::WalkTuningOptions walk;
  int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
  bool lenient = false;
  std::vector<std::string> plugins;
};

void define(const Command& command, TuneArguments& arguments) {
  command.add("what", arguments.what, "What is searched for").required().one_of({"walk"});
  command
      .add("--model", arguments.walk.model,
           "Robot file ('murosimf list formats'), or the name of one that comes with the program")
      .required()
      .offers_list("models");
  command.add("--level", arguments.walk.levels, "Levels that it shall walk at").one_at_a_time().offers_list("levels");
  command.add("--speed", arguments.walk.speed, "m/s, forward").within(0.001, 10.0).shows_default();
  command.add("--duration", arguments.walk.duration, "Simulated seconds of each walk")
      .within(1.0, 1000.0)
      .shows_default();
  command.add("--threads", arguments.threads, "Walks at a time; as many as the machine has processors if not given")
      .within(1, 256);
  command.add("--out", arguments.out, "File to write (TOML): the section [walk] for the file beside the robot");
  add_lenient(command, arguments.lenient);
  add_plugins(command, arguments.plugins);
}

int tune(const TuneArguments& arguments) {
  if (!arguments.out.empty()) files::claim_output("--out", arguments.out);
  load_plugins(arguments.plugins);
  end_gently();
  series::WalkTuningOptions options = arguments.walk;
  options.common.threads = arguments.threads;
  options.common.lenient = arguments.lenient;
  options.common.stop = interrupted;
  std::optional<Progress> progress(std::in_place);
  options.progress = [&](std::size_t done, std::size_t all) {
    progress->show(static_cast<double>(done) / static_cast<double>(all), fmt::format("{} of {} walks", done, all));
  };
  const series::WalkTuning tuning = series::tune_walk(options);
  progress.reset();
  const std::string toml = to_toml(tuning);
  Results results;
  results.write([&] { write_standard_output(to_text(tuning) + "\n" + toml); });
  if (!arguments.out.empty() && !tuning.stopped) results.write([&] { files::write_file(arguments.out, toml); });
  if (tuning.stopped)
    say_error(fmt::format("stopped by {}; some walks are missing, and nothing is written", signal_name()));
  return results.exit_code(tuning.stopped ? exit_code() : 0);
}

}  // namespace

void add_tune(CommandLine& line) {
  line.add<TuneArguments>("tune", "Search numbers of the walk for a robot, by walking", define, tune);
}

}  // namespace murosimf::app
