// `murosimf check`: the model doctor. Reads a robot, shows what is in it and says what is probably not meant.
#include <algorithm>
#include <cstdio>
#include <optional>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/last_words.h"
#include "apps/standard_output.h"
#include "murosimf/files/data_path.h"
#include "murosimf/check/model_report.h"
#include "murosimf/files/output_file.h"
#include "murosimf/check/robot_doctor.h"
#include "murosimf/appearance/robot_picture.h"
#include "murosimf/robot/robot_roles.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

/// The robot, or as much of it as can be read leniently; then `error` says what kept it from being read strictly.
struct Reading {
  io::RobotFile robot;
  std::optional<std::string> error;
};

Reading read(const std::filesystem::path& file, bool lenient) {
  try {
    return {io::read_robot(file, {.lenient = lenient}), {}};
  } catch (const SetupError& error) {
    if (lenient) throw;
    try {
      return {io::read_robot(file, {.lenient = true}), error.what()};
    } catch (const SetupError&) {
      throw error;
    }
  }
}

/// Of a file in which there is no robot at all.
int report_unreadable(const CheckOptions& options, const SetupError& error) {
  io::ModelReport report;
  report.name = options.model;
  report.findings.push_back(io::make_finding(io::Severity::error, error.what()));
  if (!options.json.empty()) write_result(options.json, "", io::to_json(report));
  say_error(error.what());
  return 1;
}

/// A TOML file that is there already has somebody's work in it.
void write_roles(const std::filesystem::path& file, const io::RobotFile& robot) {
  std::error_code none;
  if (std::filesystem::exists(std::filesystem::path(robot.draft.file).replace_extension(".toml"), none)) {
    throw SetupError(
        fmt::format("--roles '{}': the TOML file beside the robot says its roles; copy that", file.string()));
  }
  if (std::filesystem::is_regular_file(file, none)) {
    throw SetupError(fmt::format("--roles '{}': it is there already; choose another name", file.string()));
  }
  io::write_file(file, io::roles_toml(robot.draft, robot.table));
}

int show(const CheckOptions& options, const Reading& reading) {
  const auto& [robot, error] = reading;
  auto findings = io::examine(robot);
  if (error) findings.insert(findings.begin(), io::make_finding(io::Severity::error, *error));
  if (!options.picture.empty()) io::write_file(options.picture, io::robot_picture_png(robot.draft));
  if (!options.roles.empty()) write_roles(options.roles, robot);
  const auto is_error = [](const io::Finding& finding) { return finding.severity == io::Severity::error; };
  const bool wrong = std::ranges::any_of(findings, is_error);
  const io::ModelReport report = io::make_report(*robot.model, std::move(findings), robot.sensors);
  write_result(options.json, io::to_text(report), io::to_json(report));
  return wrong ? 1 : 0;
}

}  // namespace

int check(const CheckOptions& options) {
  check_json_file(options.json);
  const auto file = io::find_data_file(options.model, "models", ".xml");
  std::optional<Reading> reading;
  try {
    reading = read(file, options.lenient);
  } catch (const SetupError& error) {
    return report_unreadable(options, error);
  }
  return show(options, *reading);
}

}  // namespace murosimf::app
