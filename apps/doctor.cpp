// `murosimf doctor`: does a scene end as it does only because of its step, level, seed, gravity or gains?
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/series_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/model/error.h"
#include "murosimf/studies/doctor.h"

namespace murosimf::app {
namespace {

constexpr int flipped = 1;

struct DoctorArguments {
  SeriesArguments runs;
  std::vector<std::string> only;
  bool quick = false;
};

void define(const Command& command, DoctorArguments& arguments) {
  add_scene_file(command, arguments.runs.scene.file);
  command.add("--only", arguments.only, "What is changed, separated by commas: steps, levels, gravity, seeds, servos")
      .separated_by(',')
      .offers(studies::doctor_dimensions());
  command.add("--quick", arguments.quick, "Only the ends of each row: half as many runs");
  add_seed(command, arguments.runs.scene.seed);
  add_series(command, arguments.runs);
  add_series_end(command, arguments.runs);
}

void check(const DoctorArguments& arguments) {
  check_json_file(arguments.runs.json);
  const std::optional<double> duration = arguments.runs.duration;
  if (!duration || (*duration > 0 && *duration <= scene_file::longest_duration)) return;
  throw SetupError(fmt::format("--duration {}: must be a number above 0", *duration));
}

int doctor(const DoctorArguments& arguments) {
  check(arguments);
  studies::DoctorOptions options{.scene = arguments.runs.scene.file,
                                 .quick = arguments.quick,
                                 .dimensions = arguments.only,
                                 .duration = arguments.runs.duration,
                                 .common = options_of(arguments.runs)};
  end_gently();
  std::optional<Progress> progress(std::in_place);
  options.progress = [&](std::size_t done, std::size_t all) {
    progress->show(static_cast<double>(done) / static_cast<double>(all), fmt::format("{} of {} runs", done, all));
  };
  const studies::Checkup checkup = studies::examine(options);
  progress.reset();
  if (checkup.stopped) {
    say_error(fmt::format("stopped by {}; there is no result", signal_name()));
    return exit_code();
  }
  write_result(arguments.runs.json, to_text(checkup), to_json(checkup));
  return checkup.flips.empty() ? 0 : flipped;
}

}  // namespace

void add_doctor(CommandLine& line) {
  line.add<DoctorArguments>("doctor", "Run a scene with other steps, levels, gravity, seeds and gains: what flips?",
                            define, doctor);
}

}  // namespace murosimf::app
