// `murosimf fit-steps`: learns how the steady walk of a robot looks to its own sensors.
#include <algorithm>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/results.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/robot/step_table_file.h"
#include "murosimf/studies/step_learning.h"

namespace murosimf::app {
namespace {

struct StepArguments {
  std::string out;
  studies::StepLearningOptions steps;
  int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
  std::vector<std::string> set;
  bool lenient = false;
  std::vector<std::string> plugins;
};

void define(const Command& command, StepArguments& arguments) {
  command
      .add("--model", arguments.steps.model,
           "Robot file ('murosimf list formats'), or the name of one that comes with the program")
      .required()
      .offers_list("models");
  command.add("--out", arguments.out, "File to write (CSV): the steps of [balance] in the file beside the robot")
      .required();
  command.add("--set", arguments.set, "PATH=VALUE: change the scene of all walks ('murosimf run walk')")
      .one_at_a_time();
  command.add("--duration", arguments.steps.duration, "Simulated seconds of each walk")
      .within(3.0, 1000.0)
      .shows_default();
  command.add("--rounds", arguments.steps.rounds, "The first one without feedback, the others with what was learned")
      .within(1, 20)
      .shows_default();
  command.add("--threads", arguments.threads, "Walks at a time; as many as the machine has processors if not given")
      .within(1, 256);
  add_lenient(command, arguments.lenient);
  add_plugins(command, arguments.plugins);
}

int learn(const StepArguments& arguments) {
  files::claim_output("--out", arguments.out);
  load_plugins(arguments.plugins);
  end_gently();
  studies::StepLearningOptions options = arguments.steps;
  options.common.threads = arguments.threads;
  options.common.lenient = arguments.lenient;
  options.common.overrides = arguments.set;
  options.common.stop = interrupted;
  std::optional<Progress> progress(std::in_place);
  options.progress = [&](std::size_t done, std::size_t all) {
    progress->show(static_cast<double>(done) / static_cast<double>(all), fmt::format("{} of {} walks", done, all));
  };
  const studies::StepLearning learning = studies::learn_steps(options);
  progress.reset();
  Results results;
  results.write([&] { write_standard_output(to_text(learning)); });
  if (!learning.rounds.empty()) results.write([&] { files::write_file(arguments.out, robot::to_csv(learning.table)); });
  if (learning.stopped) say_error(fmt::format("stopped by {}; the file has the rounds that are shown", signal_name()));
  return results.exit_code(learning.stopped ? exit_code() : 0);
}

}  // namespace

void add_fit_steps(CommandLine& line) {
  line.add<StepArguments>("fit-steps", "Learn how a robot's steady walk looks to its own sensors", define, learn);
}

}  // namespace murosimf::app
