#include "murosimf/identification/fit_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/identification/bench_servo.h"
#include "murosimf/identification/parameter.h"

namespace murosimf::identification {
namespace {

using identification::FrictionModel;
using nlohmann::json;

constexpr double mrad = 1e3;

std::string rows(const std::vector<LogError>& logs, std::string_view how) {
  std::string text;
  for (const LogError& log : logs) {
    text += fmt::format("{:<24} {:<18} {:>6g} {:>8.1f} mrad  {}\n", log.log, log.trajectory, log.firmware_gain,
                        mrad * log.error, how);
  }
  return text;
}

std::string head() { return fmt::format("{:<24} {:<18} {:>6} {:>13}\n", "log", "trajectory", "gain", "error"); }

std::string mean_row(std::string_view of, double error) {
  return fmt::format("{:<50} {:>8.1f} mrad\n", of, mrad * error);
}

json json_of(const std::vector<LogError>& logs) {
  json array = json::array();
  for (const LogError& log : logs) {
    array.push_back({{"name", log.log},
                     {"trajectory", log.trajectory},
                     {"firmware_gain", log.firmware_gain},
                     {"error_rad", log.error}});
  }
  return array;
}

multibody::BenchServo bench_of(const FittedServo& fitted) {
  return identification::bench_servo(fitted.servo, fitted.encoder_offset);
}

std::string parameter_rows(const FittedServo& fitted) {
  std::string text;
  for (const auto* parameter : identification::friction_model(fitted.friction_model).parameters) {
    text += fmt::format("{:<34} {:>12.6g} {}\n", parameter->name, parameter->get(bench_of(fitted)), parameter->unit);
  }
  return text;
}

double mean_of_groups(const std::vector<UnseenGroup>& groups) {
  std::vector<LogError> all;
  for (const UnseenGroup& group : groups) all.insert(all.end(), group.logs.begin(), group.logs.end());
  return mean_error(all);
}

std::string windows_row(const FitReport& report) {
  std::string text = fmt::format("share of windows {:g}", report.window_share);
  std::string_view before = ", by what fits foresee of other trajectories: ";
  for (const TriedWindows& tried : report.tried_windows) {
    text += fmt::format("{}{:g}: {:.1f} mrad", before, tried.share, mrad * tried.error);
    before = ", ";
  }
  return text + "\n";
}

void add_windows(const FitReport& report, json& root) {
  root["window_share"] = report.window_share;
  if (report.tried_windows.empty()) return;
  json tried = json::array();
  for (const TriedWindows& one : report.tried_windows) {
    tried.push_back({{"share", one.share}, {"error_rad", one.error}});
  }
  root["tried_windows"] = std::move(tried);
}

void add_cross_validation(const FitReport& report, json& root) {
  if (report.cross_validated.empty()) return;
  json groups = json::array();
  for (const UnseenGroup& group : report.cross_validated) {
    groups.push_back({{"unseen", group.name}, {"error_rad", mean_error(group.logs)}, {"logs", json_of(group.logs)}});
  }
  root["cross_validated"] = std::move(groups);
  root["mean_cross_validated_error_rad"] = mean_of_groups(report.cross_validated);
}

}  // namespace

double mean_error(const std::vector<LogError>& logs) {
  double sum = 0;
  for (const LogError& log : logs) sum += log.error;
  return logs.empty() ? 0 : sum / static_cast<double>(logs.size());
}

std::string to_text(const FitReport& report) {
  std::vector<double> costs;
  for (const double cost : report.costs) costs.push_back(mrad * cost);
  std::string text = head() + rows(report.servo.fitted, "fitted") + rows(report.validated, "not fitted");
  for (const UnseenGroup& group : report.cross_validated) text += rows(group.logs, "left out: " + group.name);
  text += fmt::format("\n{}", mean_row("mean of fitted logs", mean_error(report.servo.fitted)));
  if (!report.validated.empty()) text += mean_row("mean of logs that were not fitted", mean_error(report.validated));
  for (const UnseenGroup& group : report.cross_validated) {
    text += mean_row(fmt::format("mean of {}, fitted to the others", group.name), mean_error(group.logs));
  }
  text += fmt::format("\n{}", parameter_rows(report.servo));
  text += fmt::format("\nmodel {}, prior {}, seed {}; cost of each start [mrad]: {:.1f}\n", report.servo.friction_model,
                      report.servo.prior, report.seed, fmt::join(costs, " "));
  return text + windows_row(report);
}

std::string to_text(const ReplayReport& report) {
  return head() + rows(report.logs, "") + "\n" +
         mean_row(fmt::format("mean, servo {}", report.servo), mean_error(report.logs));
}

std::string to_json(const FitReport& report) {
  json values = json::object();
  for (const auto* parameter : identification::friction_model(report.servo.friction_model).parameters) {
    values[parameter->name] = parameter->get(bench_of(report.servo));
  }
  json root{{"schema", files::json_schema("fit-servo")},
            {"model", report.servo.friction_model},
            {"base", report.servo.base},
            {"prior", report.servo.prior},
            {"seed", report.seed},
            {"stopped", report.stopped},
            {"costs_rad", report.costs},
            {"parameters", std::move(values)},
            {"mean_error_rad", mean_error(report.servo.fitted)},
            {"logs", json_of(report.servo.fitted)}};
  if (!report.validated.empty()) {
    root["validated"] = json_of(report.validated);
    root["mean_validated_error_rad"] = mean_error(report.validated);
  }
  add_windows(report, root);
  add_cross_validation(report, root);
  return files::json_text(std::move(root));
}

std::string to_json(const ReplayReport& report) {
  return files::json_text({{"schema", files::json_schema("replay-servo")},
                           {"servo", report.servo},
                           {"mean_error_rad", mean_error(report.logs)},
                           {"logs", json_of(report.logs)}});
}

}  // namespace murosimf::identification
