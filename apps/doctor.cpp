// `murosimf doctor`: does a scene end as it does only because of its step, level, seed, gravity or gains?
#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/interruption.h"
#include "apps/last_words.h"
#include "apps/progress.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/model/error.h"
#include "murosimf/series/doctor.h"

namespace murosimf::app {
namespace {

constexpr int flipped = 1;

struct DoctorArguments {
  SceneArguments scene;
  std::vector<std::string> only;
  std::optional<double> duration;  ///< [s]
  bool quick = false, no_cameras = false;
  std::string json;
};

void define(const Command& command, DoctorArguments& arguments) {
  SceneArguments& scene = arguments.scene;
  scene.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
  add_scene_file(command, scene.file);
  command.add("--only", arguments.only, "What is changed, separated by commas: steps, levels, gravity, seeds, servos")
      .separated_by(',')
      .offers(series::doctor_dimensions());
  command.add("--quick", arguments.quick, "Only the ends of each row: half as many runs");
  command.add("--duration", arguments.duration, "Simulated seconds of each run, instead of the scene's");
  command.add("--set", scene.overrides, "PATH=VALUE: change the scene of all runs").one_at_a_time();
  command.add("--threads", scene.threads, "Runs at a time; as many as the machine has processors if not given")
      .within(1, 256);
  add_seed(command, scene.seed);
  command.add("--no-cameras", arguments.no_cameras, "Draw nothing for cameras: they have no frames then");
  add_json(command, arguments.json);
  add_lenient(command, scene.lenient);
  add_plugins(command, scene.plugins);
  command.add(
      "--libraries", scene.libraries,
      "Load the control software that the scene file names (controller = \"library\"): it may do what it likes");
}

void check(const DoctorArguments& arguments) {
  check_json_file(arguments.json);
  if (!arguments.duration) return;
  if (*arguments.duration > 0 && *arguments.duration <= scene_file::longest_duration) return;
  throw SetupError(fmt::format("--duration {}: must be a number above 0", *arguments.duration));
}

int doctor(const DoctorArguments& arguments) {
  check(arguments);
  series::DoctorOptions options{.scene = arguments.scene.file,
                                .quick = arguments.quick,
                                .dimensions = arguments.only,
                                .duration = arguments.duration,
                                .common = options_of(arguments.scene)};
  options.common.cameras = !arguments.no_cameras;
  end_gently();
  std::optional<Progress> progress(std::in_place);
  options.progress = [&](std::size_t done, std::size_t all) {
    progress->show(static_cast<double>(done) / static_cast<double>(all), fmt::format("{} of {} runs", done, all));
  };
  const series::Checkup checkup = series::examine(options);
  progress.reset();
  if (checkup.stopped) {
    say_error(fmt::format("stopped by {}; there is no result", signal_name()));
    return exit_code();
  }
  write_result(arguments.json, to_text(checkup), to_json(checkup));
  return checkup.flips.empty() ? 0 : flipped;
}

}  // namespace

void add_doctor(CommandLine& line) {
  line.add<DoctorArguments>("doctor", "Run a scene with other steps, levels, gravity, seeds and gains: what flips?",
                            define, doctor);
}

}  // namespace murosimf::app
