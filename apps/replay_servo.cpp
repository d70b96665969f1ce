// `murosimf replay-servo`: simulates a servo as logs drove a real one, and compares.
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/results.h"
#include "apps/servo_logs.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/identification/fit_report.h"
#include "murosimf/identification/servo_log_reader.h"
#include "murosimf/logging/plot.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

namespace fs = std::filesystem;
using identification::ServoLog;

struct ReplayServoOptions {
  std::vector<std::string> logs;  ///< files and folders
  std::string servo;              ///< type or file
  std::string json;               ///< file, "-" for standard output
  std::string plot;               ///< folder for PNG files
};

void define(const Command& command, ReplayServoOptions& options) {
  command.add("logs", options.logs, "Recordings (JSON), or folders of them").required();
  command.add("--servo", options.servo, "Servo file (TOML), or the name of one that comes with the program").required();
  add_json(command, options.json);
  command.add("--plot", options.plot, "Write a PNG plot of each recording to this folder (needs gnuplot)");
}

fs::path picture_of(const std::string& folder, const ServoLog& log) { return fs::path(folder) / (log.name + ".png"); }

/// Found out before anything is computed.
void check_plots(const std::string& folder, const std::vector<ServoLog>& logs) {
  logging::check_gnuplot();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw SetupError(fmt::format("cannot make the folder '{}': {}", folder, error.message()));
  for (const ServoLog& log : logs) files::claim_output("--plot", picture_of(folder, log));
}

void plot(const fs::path& file, const ServoLog& log, const std::vector<double>& simulated, double error) {
  std::vector<double> time, goal, measured, off;
  for (std::size_t i = 0; i < simulated.size(); ++i) {
    const auto& sample = log.samples[i];
    time.push_back(sample.time);
    goal.push_back(sample.enabled ? sample.goal : std::nan(""));
    measured.push_back(sample.position);
    off.push_back(1e3 * (simulated[i] - sample.position));
  }
  logging::write_plot(
      file,
      {.title = fmt::format("{}: {}, gain {:g}, mean error {:.1f} mrad", log.name, log.trajectory, log.firmware_gain,
                            1e3 * error),
       .x_label = "time [s]",
       .panels = {{.y_label = "position [rad]",
                   .curves = {{"measured", time, measured}, {"simulated", time, simulated}, {"goal", time, goal}}},
                  {.y_label = "simulated - measured [mrad]", .curves = {{"", time, off}}}}});
}

int replay_servo(const ReplayServoOptions& options) {
  check_json_file(options.json);
  const std::vector<ServoLog> logs = identification::read_servo_logs(options.logs);
  const identification::FittedServo servo = identification::read_fitted_servo(options.servo);
  if (!options.plot.empty()) check_plots(options.plot, logs);
  const ServoReplay replay(servo, logs);
  const identification::ReplayReport report{servo.servo.type, replay.errors()};
  Results results;
  results.write([&] { write_result(options.json, identification::to_text(report), identification::to_json(report)); });
  if (!options.plot.empty()) {
    results.write([&] {
      for (std::size_t i = 0; i < logs.size(); ++i) {
        plot(picture_of(options.plot, logs[i]), logs[i], replay.positions(i), report.logs[i].error);
      }
    });
  }
  return results.exit_code(0);
}

}  // namespace

void add_replay_servo(CommandLine& line) {
  line.add<ReplayServoOptions>("replay-servo", "Simulate a servo as recordings drove a real one", define, replay_servo);
}

}  // namespace murosimf::app
