// The program `murosimf`: reads the command line and calls one of the commands.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/commands.h"
#include "apps/interruption.h"
#include "apps/last_words.h"
#include "apps/option_range.h"
#include "apps/standard_output.h"
#include "apps/version.h"
#include "murosimf/model/error.h"

namespace {

using namespace murosimf::app;

void add_log(CLI::App& run_command, RunOptions& options) {
  CLI::Option* log = run_command.add_option(
      "--log", options.log, "Record numbers: of sensors, like 'blue1.imu.*', or properties, like 'ball.ball.position'");
  CLI::Option* out = run_command.add_option("--out", options.out, "Write them to this file (CSV)");
  log->allow_extra_args(false)->needs(out);
  out->needs(log);
  run_command.add_option("--log-rate", options.log_rate, "How often properties are recorded, in Hz")
      ->needs(log)
      ->capture_default_str();
}

/// What all commands that run a scene have.
template <class Options>
void add_scene(CLI::App& command, Options& options) {
  command.add_option("scene", options.scene, "Scene file (TOML), or the name of one that comes with the program")
      ->required();
  command.add_option("--threads", options.threads, "Threads; results do not depend on their number")
      ->check(in_range(1, 256))
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Seed of all random numbers, instead of the scene's")
      ->check(in_range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
  command
      .add_option("--set", options.overrides,
                  "PATH=VALUE: change the scene, for example 'blue.*.level=simplified_dynamics'")
      ->allow_extra_args(false);
  command
      .add_option("--at", options.events,
                  "TIME:PATH=VALUE: change the scene while it runs, for example '3:blue1.level=articulated_dynamics'")
      ->allow_extra_args(false);
  command
      .add_option("--push", options.pushes,
                  "OBJECT=FORCE@BEGIN..END: push a body, for example 'blue1.torso=[60,0,0]@2..2.1' (N, world axes, s)")
      ->allow_extra_args(false);
  command.add_flag("--lenient", options.lenient, "Accept unknown elements in model files, with a warning");
}

void add_run(CLI::App& app, RunOptions& options, int& exit_code) {
  CLI::App* run_command = app.add_subcommand("run", "Run a scene and say what happened");
  add_scene(*run_command, options);
  run_command->add_option("--duration", options.duration, "Simulated seconds, instead of the scene's");
  run_command->add_option("--speed", options.speed, "'max', or simulated seconds per second: 1 is real time")
      ->capture_default_str();
  run_command->add_option("--json", options.json,
                          "Write the report as JSON to this file, or to standard output with '-'");
  run_command->add_option("--picture", options.picture, "Write a PNG picture of the field from above");
  CLI::Option* pictures =
      run_command->add_option("--pictures", options.pictures,
                              "Write PNG pictures of the bodies to this folder while the scene runs");
  run_command->add_option("--picture-every", options.picture_every, "Simulated seconds from one picture to the next")
      ->needs(pictures)
      ->capture_default_str();
  add_log(*run_command, options);
  run_command->add_flag("--no-cameras", options.no_cameras, "Draw nothing for cameras: they have no frames then");
  run_command->callback([&] { exit_code = run(options); });
}

void add_render(CLI::App& app, RenderOptions& options, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("render", "Draw a scene: a picture or a video, for people or through a camera");
  add_scene(*command, options);
  command->add_option("--time", options.time, "Simulated seconds before the picture, or before the video begins");
  command->add_option("--view", options.view,
                      "From where: overview (usual), top, side, left, right, a robot's name, or a view of the scene");
  CLI::Option* camera =
      command->add_option("--camera", options.camera, "ROBOT.CAMERA: through a camera that a robot carries");
  command->add_option("--size", options.size, "WIDTHxHEIGHT in pixels; 1280x720 if not given");
  command->add_option("--layer", options.layer, "color, depth or labels")->capture_default_str();
  command->add_option("--light", options.light, "hall, day or night, instead of the scene's");
  command->add_flag("--no-shadows", options.no_shadows, "No shadows in pictures from a view")->excludes(camera);
  command->add_option("--out", options.out, "PNG file to write");
  CLI::Option* video =
      command->add_option("--video", options.video, "Video file to write, .mp4, .webm or .gif (needs ffmpeg)");
  command->add_option("--fps", options.fps, "Pictures per second of a video; a camera has its own")
      ->needs(video)
      ->excludes(camera)
      ->capture_default_str();
  command->add_option("--slow", options.slow, "Slow motion: a video takes so many times longer than what it shows")
      ->needs(video)
      ->capture_default_str();
  command->add_option("--duration", options.duration, "Simulated seconds of a video, instead of the scene's")
      ->needs(video);
  command->callback([&] { exit_code = render(options); });
}

void add_plot(CLI::App& app, PlotOptions& options, int& exit_code) {
  CLI::App* plot_command =
      app.add_subcommand("plot", "Draw numbers over time: what 'run --log' wrote, or any such table");
  plot_command->add_option("file", options.file, "Table (CSV) with a header and the time in its first column")
      ->required();
  plot_command->add_option("patterns", options.patterns, "Columns to draw, like 'blue1.imu.*'; all if not given");
  plot_command->add_option("--out", options.out, "PNG file to write, instead of one beside the table");
  plot_command->callback([&] { exit_code = plot(options); });
}

void add_compare(CLI::App& app, CompareCommand& command, int& exit_code) {
  murosimf::compare::CompareOptions& options = command.options;
  CLI::App* compare_command = app.add_subcommand("compare", "Run a scene at several levels and say which is adequate");
  compare_command
      ->add_option("scene", options.scene, "Scene file (TOML), or the name of one that comes with the program")
      ->required();
  compare_command->add_option("--entity", options.entity, "The robot whose level changes")->required();
  compare_command->add_option("--levels", options.levels, "Levels, separated by commas; all if not given")
      ->delimiter(',');
  compare_command
      ->add_option("--contacts", options.contacts, "Contact laws, separated by commas; the scene's if not given")
      ->delimiter(',');
  compare_command
      ->add_option("--set", options.overrides, "PATH=VALUE: change the scene, for example 'field.surface=grass'")
      ->allow_extra_args(false);
  compare_command->add_option("--duration", options.duration, "Simulated seconds, instead of the scene's");
  compare_command->add_option("--seed", options.seed, "Seed of all random numbers, instead of the scene's")
      ->check(in_range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
  compare_command->add_option("--repeat", options.repeat, "Timed runs per level; their median counts")
      ->check(in_range(1, 1000))
      ->capture_default_str();
  compare_command->add_option("--threshold", command.thresholds, "NAME=VALUE: what still counts as the same")
      ->allow_extra_args(false);
  compare_command->add_option("--json", command.json, "Write JSON to this file, or to standard output with '-'");
  compare_command->add_option("--plots", command.plots, "Write PNG plots to this folder");
  compare_command->add_flag("--lenient", options.lenient, "Accept unknown elements in model files, with a warning");
  compare_command->callback([&] { exit_code = compare(command); });
}

void add_check(CLI::App& app, CheckOptions& options, int& exit_code) {
  CLI::App* check_command = app.add_subcommand("check", "Read a robot, show what is in it and what is wrong with it");
  check_command
      ->add_option("model", options.model, "Robot file (MJCF or URDF), or the name of one that comes with the program")
      ->required();
  check_command->add_option("--json", options.json, "Write JSON to this file, or to standard output with '-'");
  check_command->add_option("--picture", options.picture, "Write a PNG picture of the robot from four sides");
  check_command->add_option("--roles", options.roles,
                            "Write the soles, frames and servos that were found or guessed (TOML), to be corrected");
  check_command->add_flag("--lenient", options.lenient, "Accept unknown elements, with a warning");
  check_command->callback([&] { exit_code = check(options); });
}

void add_convert(CLI::App& app, ConvertOptions& options, int& exit_code) {
  CLI::App* convert_command = app.add_subcommand("convert", "Write a robot as one plain MJCF file, and a TOML file");
  convert_command
      ->add_option("model", options.model, "Model file (URDF or MJCF), or the name of one that comes with the program")
      ->required();
  convert_command->add_option("--out", options.out, "MJCF file (.xml) to write")->required();
  convert_command->add_option("--fit", options.fit,
                              "Put a primitive of the same volume in the place of each mesh that collides: sphere, "
                              "capsule, cylinder, box or best");
  convert_command->add_flag("--lenient", options.lenient, "Accept unknown elements, with a warning");
  convert_command->add_flag("--force", options.force, "Replace the file if it is there");
  convert_command->callback([&] { exit_code = convert(options); });
}

void add_bench(CLI::App& app, BenchOptions& options, std::string& what, int& exit_code) {
  CLI::App* bench_command = app.add_subcommand("bench", "Measure what a part of the simulation costs");
  bench_command->add_option("what", what, "collision")->required()->check(CLI::IsMember({"collision"}));
  bench_command->add_option("--json", options.json, "Write JSON to this file, or to standard output with '-'");
  bench_command->callback([&] { exit_code = bench(options); });
}

void add_list(CLI::App& app, std::string& what, int& exit_code) {
  CLI::App* list_command = app.add_subcommand("list", "List the names that there are");
  list_command->add_option("what", what, fmt::format("{}", fmt::join(list_kinds(), ", ")))
      ->required()
      ->check(CLI::IsMember(list_kinds()));
  list_command->callback([&] { exit_code = list(what); });
}

void add_fit_servo(CLI::App& app, FitServoOptions& options, int& exit_code) {
  CLI::App* fit = app.add_subcommand("fit-servo", "Find the numbers of a servo that explain recordings of it");
  fit->add_option("logs", options.logs, "Recordings (JSON), or folders of them")->required();
  fit->add_option("--model", options.model, "Friction model, m1 to m6")->capture_default_str();
  fit->add_option("--out", options.out, "Servo file (TOML) to write")->required();
  fit->add_option("--servo", options.servo,
                  "Type that firmware and voltage are taken from, instead of the recordings'");
  fit->add_option("--prior", options.prior, "What is known before: a servo type, a file (TOML), or 'none'");
  fit->add_option("--validate", options.validate, "Recordings that are not fitted, to see the error there");
  fit->add_option("--cross-validate", options.cross_validate,
                  "'trajectory' or 'gain': leave each of them out once, and say how well it is foreseen");
  fit->add_option("--seed", options.seed, "Seed of the search; the same seed finds the same servo")
      ->check(in_range(std::int64_t{0}, std::int64_t{1000000000}))
      ->capture_default_str();
  fit->add_option("--starts", options.starts, "Searches from different points")
      ->check(in_range(1, 1000))
      ->capture_default_str();
  fit->add_option("--windows", options.windows, "Share of short windows in what is minimized, against whole recordings")
      ->check(in_range(0.0, 1.0))
      ->capture_default_str();
  fit->add_option("--threads", options.threads, "Threads, instead of all; results do not depend on their number")
      ->check(in_range(1, 256));
  fit->add_option("--json", options.json, "Write JSON to this file, or to standard output with '-'");
  fit->callback([&] { exit_code = fit_servo(options); });
}

void add_replay_servo(CLI::App& app, ReplayServoOptions& options, int& exit_code) {
  CLI::App* replay = app.add_subcommand("replay-servo", "Simulate a servo as recordings drove a real one");
  replay->add_option("logs", options.logs, "Recordings (JSON), or folders of them")->required();
  replay->add_option("--servo", options.servo, "Servo file (TOML), or the name of one that comes with the program")
      ->required();
  replay->add_option("--json", options.json, "Write JSON to this file, or to standard output with '-'");
  replay->add_option("--plot", options.plot, "Write a PNG plot of each recording to this folder (needs gnuplot)");
  replay->callback([&] { exit_code = replay_servo(options); });
}

void add_lens(CLI::App& app, LensOptions& options, int& exit_code) {
  CLI::App* lens_command = app.add_subcommand("lens", "Show the calibration of a camera, or convert it");
  lens_command
      ->add_option("file", options.file,
                   "Calibration (YAML as ROS writes it), or the name of one that comes with the program")
      ->required();
  lens_command->add_option("--as", options.model,
                           "Say it in the words of another lens model: perspective, plumb_bob, rational_polynomial, "
                           "equidistant or ray_polynomial");
  lens_command->add_option("--out", options.out, "Calibration to write (YAML)");
  lens_command->callback([&] { exit_code = lens(options); });
}

/// Commands that say what the definition of the others gives.
void add_shell(CLI::App& app, std::string& shell) {
  CLI::App* completion = app.add_subcommand("completion", "Write a script that completes this command line in a shell");
  completion->add_option("shell", shell, "bash or zsh")->required()->check(CLI::IsMember(completion_shells()));
  completion->callback([&] { write_standard_output(completion_script(app, shell)); });
  app.add_subcommand("man", "Write the manual page (roff): murosimf man | man -l -")->callback([&] {
    write_standard_output(manual_page(app));
  });
}

/// The parser would only say that a command is required.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  const std::vector<std::string_view> commands(names.begin(), names.end());
  if (argc < 2 || argv[1][0] == '-') return;
  if (std::find(commands.begin(), commands.end(), argv[1]) == commands.end()) {
    throw murosimf::SetupError(murosimf::unknown_name("command", argv[1], commands));
  }
}

}  // namespace

int main(int argc, char** argv) {
  say_last_words_of_everything();
  catch_signals();
  CLI::App app("MuRoSimF: teams of humanoid robots at exchangeable levels of physical detail", "murosimf");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  RunOptions run_options;
  PlotOptions plot_options;
  RenderOptions render_options;
  CompareCommand compare_command;
  CheckOptions check_options;
  ConvertOptions convert_options;
  BenchOptions bench_options;
  FitServoOptions fit_servo_options;
  ReplayServoOptions replay_servo_options;
  LensOptions lens_options;
  std::string what, what_to_bench, shell;
  int exit_code = 0;
  add_run(app, run_options, exit_code);
  add_render(app, render_options, exit_code);
  add_plot(app, plot_options, exit_code);
  add_compare(app, compare_command, exit_code);
  add_check(app, check_options, exit_code);
  add_convert(app, convert_options, exit_code);
  add_list(app, what, exit_code);
  add_bench(app, bench_options, what_to_bench, exit_code);
  add_fit_servo(app, fit_servo_options, exit_code);
  add_replay_servo(app, replay_servo_options, exit_code);
  add_lens(app, lens_options, exit_code);
  add_shell(app, shell);
  try {
    refuse_unknown_command(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    say_error(error.what(), "; --help shows what there is");
    return users_mistake;
  } catch (...) {
    return exit_code_of_exception();
  }
  return exit_code;
}
