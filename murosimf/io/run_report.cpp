#include "murosimf/io/run_report.h"

#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

namespace murosimf::io {
namespace {

toml::table entity_table(const EntityReport& e) {
  return toml::table{{"name", e.name},
                     {"model", e.model},
                     {"level", e.level},
                     {"contact", e.contact},
                     {"controller", e.controller},
                     {"team", e.team},
                     {"position", toml::array{e.position.x, e.position.y, e.position.z}},
                     {"distance_m", e.distance},
                     {"falls", e.falls},
                     {"frozen", e.frozen}};
}

toml::table algorithm_table(const AlgorithmStatistics& a) {
  return toml::table{{"name", a.name}, {"rate_hz", a.rate_hz}, {"calls", a.calls}, {"us_per_call", a.us_per_call}};
}

}  // namespace

std::string to_text(const RunReport& report) {
  std::string text = fmt::format("{:<12} {:<20} {:<20} {:<12} {:>9} {:>8} {:>6} {:>18}\n", "entity", "level", "contact",
                                 "controller", "walked", "", "falls", "position");
  for (const EntityReport& e : report.entities) {
    text += fmt::format("{:<12} {:<20} {:<20} {:<12} {:>7.2f} m {:>8} {:>6} {:>8.2f} {:>8.2f} m\n", e.name, e.level,
                        e.contact.empty() ? "-" : e.contact, e.controller.empty() ? "-" : e.controller, e.distance,
                        e.frozen ? "frozen" : "", e.falls, e.position.x, e.position.y);
  }
  text += fmt::format("\n{:<22} {:>9} {:>10} {:>12}\n", "algorithm", "rate", "calls", "time a call");
  for (const AlgorithmStatistics& a : report.algorithms) {
    text += fmt::format("{:<22} {:>6.0f} Hz {:>10} {:>9.2f} us\n", a.name, a.rate_hz, a.calls, a.us_per_call);
  }
  text += fmt::format("\n{:.2f} s simulated in {:.3f} s: {:.0f} times real time on {} thread{}\n", report.simulated,
                      report.wall, report.real_time_factor, report.threads, report.threads == 1 ? "" : "s");
  text += fmt::format("seed {}, state hash {:016x}\n", report.seed, report.state_hash);
  for (const Event& event : report.events) text += fmt::format("{:.3f} s: {}\n", seconds(event.time), event.text);
  for (const std::string& warning : report.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

std::string to_json(const RunReport& report) {
  toml::table root{{"scene", report.scene},
                   {"simulated_s", report.simulated},
                   {"wall_s", report.wall},
                   {"real_time_factor", report.real_time_factor},
                   {"threads", report.threads},
                   {"seed", static_cast<std::int64_t>(report.seed)},
                   {"state_hash", fmt::format("{:016x}", report.state_hash)}};
  toml::array entities, algorithms, events, warnings;
  for (const EntityReport& e : report.entities) entities.push_back(entity_table(e));
  for (const AlgorithmStatistics& a : report.algorithms) algorithms.push_back(algorithm_table(a));
  for (const Event& event : report.events) {
    events.push_back(toml::table{{"time_s", seconds(event.time)}, {"text", event.text}});
  }
  for (const std::string& warning : report.warnings) warnings.push_back(warning);
  root.insert("entities", std::move(entities));
  root.insert("algorithms", std::move(algorithms));
  root.insert("events", std::move(events));
  root.insert("warnings", std::move(warnings));
  std::stringstream stream;
  stream << toml::json_formatter(root) << "\n";
  return stream.str();
}

}  // namespace murosimf::io
