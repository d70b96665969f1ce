// `murosimf check`: reads a robot, shows what is in it and says what is probably not meant.
#include <algorithm>
#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/results.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/appearance/robot_picture.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/model_report.h"
#include "murosimf/robot/robot_checks.h"
#include "murosimf/robot/role_inference.h"

namespace murosimf::app {
namespace {

struct CheckOptions {
  std::string model;
  std::string json;     ///< file, "-" for standard output
  std::string picture;  ///< PNG file
  std::string roles;    ///< TOML file
  bool all = false;
  bool lenient = false;
  std::vector<std::string> xacro;    ///< name:=value
  std::string body;                  ///< of the robot, if the file has several
  std::vector<std::string> plugins;  ///< sensors of the robot may come from there
};

void define(const Command& command, CheckOptions& options) {
  command
      .add("model", options.model,
           "Robot file ('murosimf list formats'), or the name of one that comes with the program")
      .required()
      .offers_list("models");
  add_json(command, options.json);
  command.add("--picture", options.picture, "Write a PNG picture of the robot from four sides");
  command.add("--roles", options.roles,
              "Write the soles, frames and servos that were found or guessed (TOML), to be corrected");
  command.add("--all", options.all, "Show every finding; else at most ten lines, those of one kind in one");
  add_lenient(command, options.lenient);
  add_xacro(command, options.xacro);
  add_body(command, options.body);
  add_plugins(command, options.plugins);
}

/// The robot, or as much of it as can be read leniently; then `error` says what kept it from being read strictly.
struct Reading {
  robot::RobotFile robot;
  std::optional<std::string> error;
};

Reading read(const std::filesystem::path& file, const robot_formats::ReaderOptions& options) {
  try {
    return {robot::read_robot(file, options), {}};
  } catch (const SetupError& error) {
    if (options.lenient) throw;
    robot_formats::ReaderOptions leniently = options;
    leniently.lenient = true;
    try {
      return {robot::read_robot(file, leniently), error.what()};
    } catch (const SetupError&) {
      throw error;
    }
  }
}

/// Of a file in which there is no robot at all.
int report_unreadable(const CheckOptions& options, const SetupError& error) {
  robot::ModelReport report;
  report.name = options.model;
  report.findings.push_back(robot::make_finding(robot::Severity::error, error.what()));
  robot::shorten_paths(report.findings, std::filesystem::current_path());
  if (!options.json.empty()) write_result(options.json, "", robot::to_json(report));
  say_error(error.what());
  return 1;
}

/// A TOML file that exists may have been edited by hand: it is not overwritten.
void check_roles(const std::filesystem::path& file, const robot::RobotFile& robot) {
  std::error_code none;
  if (std::filesystem::exists(std::filesystem::path(robot.description.file).replace_extension(".toml"), none)) {
    throw SetupError(
        fmt::format("--roles '{}': the TOML file beside the robot says its roles; copy that", file.string()));
  }
  if (std::filesystem::is_regular_file(file, none)) {
    throw SetupError(fmt::format("--roles '{}': it is there already; choose another name", file.string()));
  }
}

int show(const CheckOptions& options, const Reading& reading) {
  const auto& [robot, error] = reading;
  auto findings = robot::examine(robot);
  if (error) findings.insert(findings.begin(), robot::make_finding(robot::Severity::error, *error));
  robot::shorten_paths(findings, std::filesystem::current_path());
  if (!options.roles.empty()) check_roles(options.roles, robot);
  const auto is_error = [](const robot::Finding& finding) { return finding.severity == robot::Severity::error; };
  const bool wrong = std::ranges::any_of(findings, is_error);
  const robot::ModelReport report = robot::make_report(*robot.model, std::move(findings), robot.sensors);
  Results results;
  if (!options.roles.empty()) {
    results.write([&] { files::write_file(options.roles, robot::roles_toml(robot.description, robot.table)); });
  }
  results.write([&] { write_result(options.json, robot::to_text(report, options.all), robot::to_json(report)); });
  // the last, since not every machine can draw
  if (!options.picture.empty()) {
    results.write([&] { files::write_file(options.picture, appearance::robot_picture_png(robot.description)); });
  }
  return results.exit_code(wrong ? 1 : 0);
}

int check(const CheckOptions& options) {
  load_plugins(options.plugins);
  check_json_file(options.json);
  if (!options.picture.empty()) claim_picture("--picture", options.picture);
  if (!options.roles.empty()) files::claim_output("--roles", options.roles);
  const auto file = files::find_data_file(options.model, "models", ".xml");
  files::note_input(file);  // refused before the readers, whose errors are findings
  const robot_formats::ReaderOptions how{.lenient = options.lenient,
                                         .xacro = xacro_values(options.xacro),
                                         .body = options.body};
  std::optional<Reading> reading;
  try {
    reading = read(file, how);
  } catch (const SetupError& error) {
    return report_unreadable(options, error);
  }
  return show(options, *reading);
}

}  // namespace

void add_check(CommandLine& line) {
  line.add<CheckOptions>("check", "Read a robot, show what is in it and what is wrong with it", define, check);
}

}  // namespace murosimf::app
