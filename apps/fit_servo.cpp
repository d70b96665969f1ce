// `murosimf fit-servo`: finds the numbers of a servo that explain logs of it.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/results.h"
#include "apps/servo_logs.h"
#include "apps/standard_output.h"
#include "murosimf/component_files/servo_table.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/identification/bench_servo.h"
#include "murosimf/identification/fit_report.h"
#include "murosimf/identification/folds.h"
#include "murosimf/identification/prior_file.h"
#include "murosimf/identification/search.h"
#include "murosimf/identification/servo_log_reader.h"
#include "murosimf/identification/window_choice.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

namespace fs = std::filesystem;
using identification::Fold;
using identification::ServoLog;
using Logs = std::vector<ServoLog>;

struct FitServoOptions {
  std::vector<std::string> logs;      ///< files and folders
  std::string model = "m4";           ///< of friction: m1 to m6
  std::string out;                    ///< servo file
  std::string servo;                  ///< type that firmware and voltage are taken from; empty: what the logs name
  std::string prior;                  ///< "none", a type or a file; empty: that of the type, if there is one
  std::vector<std::string> validate;  ///< logs that are not fitted
  std::string cross_validate;         ///< "trajectory" or "gain"; empty: no
  std::int64_t seed = 1;
  int starts = 4;
  std::optional<double> windows;  ///< share of windows in what is minimized, 0 to 1; nothing: what foresees best
  int threads = 0;                ///< 0: as many as the machine has
  std::string json;               ///< file, "-" for standard output
};

void define(const Command& command, FitServoOptions& options) {
  command.add("logs", options.logs, "Recordings (JSON), or folders of them").required();
  command.add("--model", options.model, "Friction model, m1 to m6").shows_default();
  command.add("--out", options.out, "Servo file (TOML) to write").required();
  command.add("--servo", options.servo, "Type that firmware and voltage are taken from, instead of the recordings'");
  command.add("--prior", options.prior, "What is known before: a servo type, a file (TOML), or 'none'");
  command.add("--validate", options.validate, "Recordings that are not fitted, to see the error there");
  command.add("--cross-validate", options.cross_validate,
              "'trajectory' or 'gain': leave each of them out once, and say how well it is foreseen");
  command.add("--seed", options.seed, "Seed of the search; the same seed finds the same servo")
      .within(0, 1000000000)
      .shows_default();
  command.add("--starts", options.starts, "Searches from different points").within(1, 1000).shows_default();
  command
      .add("--windows", options.windows,
           "Share of short windows in what is minimized, against whole recordings, instead of the one that foresees "
           "best")
      .within(0.0, 1.0);
  command.add("--threads", options.threads, "Threads, instead of all; results do not depend on their number")
      .within(1, 256);
  add_json(command, options.json);
}

/// The type that all logs name.
std::string motor_of(const Logs& logs) {
  for (const ServoLog& log : logs) {
    if (log.motor.empty()) throw SetupError(fmt::format("log '{}' names no motor; say --servo TYPE", log.name));
    if (log.motor != logs.front().motor) {
      throw SetupError(fmt::format("logs '{}' and '{}' are of other motors; fit each alone, or say --servo TYPE",
                                   logs.front().name, log.name));
    }
  }
  return logs.front().motor;
}

/// Everything that stays the same from fit to fit.
struct Task {
  const FitServoOptions& options;
  const identification::FrictionModel& model;
  std::string base_name, prior_name;
  Servo base;
  identification::Prior prior;
};

Task task_of(const FitServoOptions& options, const Logs& logs) {
  const std::string type = options.servo.empty() ? motor_of(logs) : options.servo;
  const Servo base = component_files::read_servo(type);
  const std::string prior = options.prior.empty() ? identification::prior_of_type(base.type) : options.prior;
  return {options, identification::friction_model(options.model), type, prior, base, identification::read_prior(prior)};
}

/// How long a fit searches.
struct Effort {
  int starts = 1;
  int evaluations = 8000, refinement = 1500;
};

/// Of fits that only choose between windows: they take as long together as one fit to all logs, nearly.
Effort short_effort(const FitServoOptions& options) { return {std::max(1, options.starts / 2), 4000, 500}; }

int threads_of(const FitServoOptions& options, int starts) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return std::min(starts, options.threads > 0 ? options.threads : all);
}

struct Result {
  identification::FittedServo servo;
  std::vector<double> costs;
};

/// `windows`: their share.
Result fit(const Task& task, const Logs& logs, double windows, const Effort& effort, const std::string& what) {
  const auto bench = identification::bench_servo(task.base, 0);
  identification::ObjectiveOptions objective_options{.duty_per_gain = identification::duty_per_gain(task.base),
                                                     .duty_limit = bench.duty_limit,
                                                     .current_limit = bench.current_limit,
                                                     .window_share = windows};
  const identification::Objective objective(task.model, task.prior, logs, objective_options);
  Progress line;
  const auto coarse = identification::search(objective,
                                             {.seed = static_cast<std::uint64_t>(task.options.seed),
                                              .starts = effort.starts,
                                              .evaluations = effort.evaluations,
                                              .threads = threads_of(task.options, effort.starts),
                                              .stop = interrupted},
                                             [&](double share, double best) {
                                               line.show(share, fmt::format("{}, cost {:.1f} mrad", what, 1e3 * best));
                                             });
  // with the step of a replay: where an arm stops must not depend on the step of the search
  objective_options.step = replay_step;
  const identification::Objective fine(task.model, task.prior, logs, objective_options);
  const auto found = identification::refine(coarse, fine, effort.refinement, interrupted);
  return {{.servo = identification::servo_of(found.servo, task.base),
           .friction_model = std::string(task.model.name),
           .encoder_offset = found.servo.encoder_offset,
           .base = fs::path(task.base_name).stem().string(),
           .prior = fs::path(task.prior_name).stem().string(),
           .fitted = {}},
          found.costs};
}

/// What fits to the other folds foresee of each; as far as they come before an interruption.
std::vector<identification::UnseenGroup> foresee(const Task& task, const std::vector<Fold>& folds, double windows,
                                                 const Effort& effort) {
  std::vector<identification::UnseenGroup> groups;
  for (const Fold& fold : folds) {
    const Result other =
        fit(task, fold.fitted, windows, effort, fmt::format("windows {:g}, without {}", windows, fold.unseen));
    if (interrupted()) break;
    groups.push_back({fold.unseen, ServoReplay(other.servo, fold.left_out).errors()});
  }
  return groups;
}

identification::WindowTrial trial_of(double share, const std::vector<identification::UnseenGroup>& groups) {
  identification::WindowTrial trial{share, {}};
  for (const auto& group : groups) {
    for (const auto& log : group.logs) trial.errors.push_back(log.error);
  }
  return trial;
}

/// The share of windows that foresees other trajectories best; `usual` if an interruption comes first.
double choose_windows(const Task& task, const std::vector<Fold>& folds, double usual,
                      identification::FitReport& report) {
  std::vector<identification::WindowTrial> trials;
  std::size_t usual_trial = 0;
  for (const double share : identification::window_shares) {
    if (share == usual) usual_trial = trials.size();
    trials.push_back(trial_of(share, foresee(task, folds, share, short_effort(task.options))));
    if (interrupted()) return usual;
    report.tried_windows.push_back({share, identification::mean_error(trials.back())});
  }
  return trials[identification::best_trial(trials, usual_trial)].share;
}

/// The servo, with the share of windows that was asked for or foresees best. One is there already when an interruption
/// comes while others are tried.
Result fit_with_best_windows(const Task& task, const Logs& logs, identification::FitReport& report) {
  const Effort full{.starts = task.options.starts};
  report.window_share = task.options.windows.value_or(identification::usual_window_share(task.model));
  Result result = fit(task, logs, report.window_share, full, "fit");
  if (task.options.windows || !identification::has_other_trajectories(logs)) return result;
  const double best = choose_windows(task, identification::folds(logs, "trajectory"), report.window_share, report);
  if (best == report.window_share) return result;
  Result other = fit(task, logs, best, full, "fit again");
  if (interrupted()) return result;
  report.window_share = best;
  return other;
}

int fit_servo(const FitServoOptions& options) {
  identification::check_search();
  (void)identification::friction_model(options.model);
  check_json_file(options.json);
  files::claim_output("--out", options.out);
  const Logs logs = identification::read_servo_logs(options.logs);
  const Logs unseen = options.validate.empty() ? Logs{} : identification::read_servo_logs(options.validate);
  const Task task = task_of(options, logs);
  std::vector<Fold> folds;
  if (!options.cross_validate.empty()) folds = identification::folds(logs, options.cross_validate);

  end_gently();
  identification::FitReport report{.servo = {}, .seed = static_cast<std::uint64_t>(options.seed)};
  const Result result = fit_with_best_windows(task, logs, report);
  report.servo = result.servo;
  report.costs = result.costs;
  report.servo.fitted = ServoReplay(report.servo, logs).errors();
  if (!unseen.empty()) report.validated = ServoReplay(report.servo, unseen).errors();
  if (!interrupted()) report.cross_validated = foresee(task, folds, report.window_share, {.starts = options.starts});
  report.stopped = interrupted();
  Results results;
  results.write([&] { files::write_file(options.out, identification::to_toml(report.servo)); });
  const bool there = results.all();
  results.write([&] { write_result(options.json, identification::to_text(report), identification::to_json(report)); });
  if (report.stopped && there) {
    say_error(fmt::format("stopped by {}; '{}' is the best so far", signal_name(), options.out));
  }
  return results.exit_code(exit_code());
}

}  // namespace

void add_fit_servo(CommandLine& line) {
  line.add<FitServoOptions>("fit-servo", "Find the numbers of a servo that explain recordings of it", define,
                            fit_servo);
}

}  // namespace murosimf::app
