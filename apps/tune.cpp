// `murosimf tune walk`, `tune balance` and `tune MOTION`: search numbers of a walk, of one with feedback, or a key-frame motion for one
// robot, by playing it.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/record_options.h"
#include "apps/results.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/step_table_file.h"
#include "murosimf/studies/balance_tuning.h"
#include "murosimf/studies/walk_tuning.h"

namespace murosimf::app {
namespace {

struct TuneArguments {
  std::string what, model;
  std::string goal, from, ball;           // of a motion
  std::optional<double> toward, fastest;  // [deg], [rad/s] likewise
  std::optional<double> speed, duration;  // [m/s], [s] of a walk
  std::optional<double> impulse;          // [N s] of pushes
  std::vector<std::string> levels;
  int evaluations = 480;
  std::optional<double> minutes;
  std::optional<std::uint64_t> seed;
  std::string out;
  int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
  bool lenient = false;
  std::vector<std::string> plugins;
};

void define(const Command& command, TuneArguments& arguments) {
  command
      .add("what", arguments.what,
           "walk, balance (the walk with feedback), or a key-frame motion: a file, or the name of one that comes with "
           "the program")
      .required()
      .offers({"walk", "balance"});
  command
      .add("--model", arguments.model,
           "Robot file ('murosimf list formats'), or the name of one that comes with the program")
      .required()
      .offers_list("models");
  command.add("--goal", arguments.goal, "What the motion shall come to: stands (if not given), kicks or lies")
      .one_of({"stands", "kicks", "lies"});
  command
      .add("--from", arguments.from,
           "How the robot begins: standing (kicks, lies), or lying on its front, back, left or right")
      .one_of({"standing", "front", "back", "left", "right"});
  command
      .add("--toward", arguments.toward,
           "deg, counterclockwise from ahead: where the ball or the robot shall go; ahead if not given")
      .within(0.0, 360.0);
  command.add("--ball", arguments.ball,
              "X,Y in m: where the ball of a kick lies, from the robot; 0.2,-0.056 if not given");
  command
      .add("--fastest", arguments.fastest,
           "rad/s, of the targets of a motion's joints for which the robot's files know no largest rate; any if not "
           "given")
      .within(0.1, 1000.0);
  command.add("--speed", arguments.speed, "m/s, of a walk forward; 0.1 if not given, 0.15 with balance")
      .within(0.001, 10.0);
  command.add("--duration", arguments.duration, "Simulated seconds of each walk; 8 if not given, 7 with balance")
      .within(1.0, 1000.0);
  command
      .add("--impulse", arguments.impulse,
           "N s, of the pushes of a balance; 0.45 m sqrt(g l) with mass m and length of the legs l if not given")
      .within(1e-3, 1e5);
  command.add("--levels", arguments.levels, "Levels, separated by commas; all but kinematic_walking if not given")
      .separated_by(',')
      .offers_list("levels");
  command.add("--evaluations", arguments.evaluations, "Candidates that are tried at most")
      .within(1, 10'000'000)
      .shows_default();
  command.add("--minutes", arguments.minutes, "Of wall time, after which no generation begins; any if not given")
      .within(0.0, 1e6);
  command.add("--seed", arguments.seed, "Of the search and of the circumstances; 1 if not given")
      .within(std::int64_t{0}, std::numeric_limits<std::int64_t>::max());
  command.add("--threads", arguments.threads, "Runs at a time; as many as the machine has processors if not given")
      .within(1, 256);
  command.add("--out", arguments.out,
              "File to write (TOML): the motion, or section [walk] or [balance] for the file beside the robot, the "
              "latter with its "
              "table of steps in a file of its own (FILE_steps.csv). FILE.state beside it is what the same command "
              "goes on with "
              "after it was ended");
  add_lenient(command, arguments.lenient);
  add_plugins(command, arguments.plugins);
}

/// An option that this search has no use for is an error.
void refuse(bool given, const char* option, const char* what) {
  if (given) throw SetupError(fmt::format("{} is nothing that tuning {} asks for", option, what));
}

void check(const TuneArguments& arguments) {
  refuse(arguments.what != "balance" && arguments.impulse.has_value(), "--impulse",
         "a walk without pushes or a motion");
  if (arguments.what == "walk" || arguments.what == "balance") {
    refuse(!arguments.goal.empty(), "--goal", "a walk");
    refuse(!arguments.from.empty(), "--from", "a walk");
    refuse(arguments.toward.has_value(), "--toward", "a walk");
    refuse(!arguments.ball.empty(), "--ball", "a walk");
    refuse(arguments.fastest.has_value(), "--fastest", "a walk");
    return;
  }
  refuse(arguments.speed.has_value(), "--speed", "a motion");
  refuse(arguments.duration.has_value(), "--duration", "a motion");
  const bool stands = arguments.goal.empty() || arguments.goal == "stands";
  refuse(stands && arguments.toward.has_value(), "--toward", "a motion whose goal is 'stands'");
  refuse(arguments.goal != "kicks" && !arguments.ball.empty(), "--ball", "a motion that does not kick");
  if (stands && arguments.from.empty())
    throw SetupError(
        "--from is missing: the robot shall stand after how it begins: front, back, left, right or standing");
}

/// [m]
Vec3d place_of_ball(const std::string& text) {
  if (text.empty()) return {0.2, -0.056, 0};
  Vec3d place;
  const char* end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, place.x);
  if (read.ec == std::errc{} && read.ptr != end && *read.ptr == ',')
    read = std::from_chars(read.ptr + 1, end, place.y);
  else
    read.ec = std::errc::invalid_argument;
  if (read.ec == std::errc{} && read.ptr == end && std::abs(place.x) < 10 && std::abs(place.y) < 10) return place;
  throw SetupError(fmt::format("--ball '{}': must be X,Y in m, like 0.2,-0.056", text));
}

studies::MotionTask task_of(const TuneArguments& arguments) {
  constexpr double degree = pi / 180;
  struct Lies {
    double roll, pitch;  // [rad]
  };
  static const std::map<std::string, Lies> starts{{"", {0, 0}},           {"standing", {0, 0}},
                                                  {"front", {0, pi / 2}}, {"back", {0, -pi / 2}},
                                                  {"left", {-pi / 2, 0}}, {"right", {pi / 2, 0}}};
  studies::MotionTask task;
  if (arguments.goal == "kicks") task.goal = studies::MotionGoal::kicks;
  if (arguments.goal == "lies") task.goal = studies::MotionGoal::lies;
  task.roll = starts.at(arguments.from).roll;
  task.pitch = starts.at(arguments.from).pitch;
  task.direction = degree * arguments.toward.value_or(0);
  task.ball = place_of_ball(arguments.ball);
  task.fastest = arguments.fastest.value_or(0);
  task.ball_options.mass = 0.3;      // [kg] as of scene `kick`
  task.ball_options.radius = 0.065;  // [m]
  return task;
}

/// What is there and is no file: a terminal, a pipe, /dev/null. /dev/shm holds files.
bool is_device(const std::string& out) {
  std::error_code none;
  return std::filesystem::is_other(out, none);
}

/// Of a balance, beside --out; empty: it goes nowhere.
std::filesystem::path steps_file(const TuneArguments& arguments) {
  if (arguments.what != "balance" || arguments.out.empty() || is_device(arguments.out)) return {};
  const std::filesystem::path out = arguments.out;
  return out.parent_path() / (out.stem().string() + "_steps.csv");
}

/// None for what is written to a device or a pipe.
std::filesystem::path state_file(const std::string& out) {
  return out.empty() || is_device(out) ? std::filesystem::path() : std::filesystem::path(out + ".state");
}

studies::TuningBudget budget_of(const TuneArguments& arguments, Progress& progress) {
  studies::TuningBudget budget{.evaluations = static_cast<std::size_t>(arguments.evaluations),
                               .seed = arguments.seed.value_or(1),
                               .state = state_file(arguments.out),
                               .program = this_program()};
  if (arguments.minutes) budget.minutes = *arguments.minutes;
  budget.progress = [&progress](const studies::CostSearchProgress& now) {
    progress.show(now.share, fmt::format("{} of {} evaluations, best cost {:.4f}", now.evaluations, now.of, now.best));
  };
  return budget;
}

/// As it could be typed, without the folder of the program.
std::string how_it_was_found() {
  const std::string line = command_line();
  const std::size_t end = line.find(' ');
  return "found by: murosimf" + (end == std::string::npos ? "" : line.substr(end)) + "\n" + this_program();
}

/// With the head, which says how it was found.
template <class Tuning>
std::string toml_of(const TuneArguments&, const Tuning& tuning, const std::string& head) {
  return to_toml(tuning, head);
}
std::string toml_of(const TuneArguments& arguments, const studies::BalanceTuning& tuning, const std::string& head) {
  const std::string steps = steps_file(arguments).filename().string();
  return to_toml(tuning, head, steps.empty() ? "steps.csv" : steps);
}

template <class Tuning>
void write_steps(const TuneArguments&, const Tuning&) {}
void write_steps(const TuneArguments& arguments, const studies::BalanceTuning& tuning) {
  if (tuning.steps) files::write_file(steps_file(arguments), robot::to_csv(*tuning.steps));
}

/// Shows and writes what was found.
template <class Tuning>
int finish(const TuneArguments& arguments, const Tuning& tuning) {
  const studies::CostSearch& search = tuning.search;
  const std::filesystem::path state = state_file(arguments.out);
  if (search.taken_over > 0)
    say_note(fmt::format("went on after {} evaluations with what was in '{}'", search.taken_over, state.string()));
  const bool found = search.evaluations > 0;
  const std::string toml =
      toml_of(arguments, tuning, how_it_was_found() + (search.stopped ? "\nnot yet at its end" : ""));
  Results results;
  if (found && arguments.out.empty()) results.write([&] { write_standard_output(to_text(tuning) + "\n" + toml); });
  if (found && !arguments.out.empty()) {
    results.write([&] { write_standard_output(to_text(tuning)); });
    results.write([&] { files::write_file(arguments.out, toml); });
    if (!is_device(arguments.out)) results.write([&] { write_steps(arguments, tuning); });
  }
  std::error_code ignored;
  if (!search.stopped && !state.empty() && results.exit_code(0) == 0) std::filesystem::remove(state, ignored);
  if (search.stopped) {
    say_error(fmt::format("stopped by {}; {}{}", signal_name(),
                          found ? "the best so far is there" : "nothing was found",
                          state.empty() ? "" : ", and the same command goes on"));
  }
  return results.exit_code(search.stopped ? exit_code() : 0);
}

int tune(const TuneArguments& arguments) {
  check(arguments);
  if (!arguments.out.empty()) files::claim_output("--out", arguments.out);
  if (!state_file(arguments.out).empty()) files::claim_continued("the state of --out", state_file(arguments.out));
  if (!steps_file(arguments).empty()) files::claim_output("the table of --out", steps_file(arguments));
  load_plugins(arguments.plugins);
  end_gently();
  scene::SceneOptions common;
  common.threads = arguments.threads;
  common.lenient = arguments.lenient;
  common.stop = interrupted;
  std::optional<Progress> progress(std::in_place);
  const std::vector<std::string>& levels = arguments.levels.empty() ? studies::usual_tuning_levels() : arguments.levels;
  if (arguments.what == "walk") {
    const studies::WalkTuning tuning = studies::tune_walk({.model = arguments.model,
                                                           .levels = levels,
                                                           .speed = arguments.speed.value_or(0.1),
                                                           .duration = arguments.duration.value_or(8),
                                                           .budget = budget_of(arguments, *progress),
                                                           .common = common});
    progress.reset();
    return finish(arguments, tuning);
  }
  if (arguments.what == "balance") {
    const studies::BalanceTuning tuning = studies::tune_balance({.model = arguments.model,
                                                                 .levels = levels,
                                                                 .speed = arguments.speed.value_or(0.15),
                                                                 .impulse = arguments.impulse,
                                                                 .duration = arguments.duration.value_or(7),
                                                                 .budget = budget_of(arguments, *progress),
                                                                 .common = common});
    progress.reset();
    return finish(arguments, tuning);
  }
  const studies::MotionTuning tuning = studies::tune_motion({.motion = arguments.what,
                                                             .model = arguments.model,
                                                             .task = task_of(arguments),
                                                             .levels = levels,
                                                             .budget = budget_of(arguments, *progress),
                                                             .common = common});
  progress.reset();
  return finish(arguments, tuning);
}

}  // namespace

void add_tune(CommandLine& line) {
  line.add<TuneArguments>("tune", "Search numbers of a walk or a motion for a robot, by playing it", define, tune);
}

}  // namespace murosimf::app
