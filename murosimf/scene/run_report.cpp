#include "murosimf/scene/run_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/scene/drawing_packets_json.h"

namespace murosimf::scene {
namespace {

using nlohmann::json;

json entity_object(const EntityReport& e) {
  return {{"name", e.name},
          {"model", e.model},
          {"level", e.level},
          {"contact", e.contact},
          {"controller", e.controller},
          {"team", e.team},
          {"position", {e.position.x, e.position.y, e.position.z}},
          {"distance_m", e.distance},
          {"falls", e.falls},
          {"frozen", e.frozen},
          {"present", e.present}};
}

json algorithm_object(const AlgorithmStatistics& a) {
  return {{"name", a.name}, {"rate_hz", a.rate_hz}, {"calls", a.calls}, {"us_per_call", a.us_per_call}};
}

json sensor_object(const sensors::Reading& reading) {
  json outputs = json::object();
  for (const sensors::Output& output : reading.info->outputs) {
    const auto values = reading.output(output.name);  // numbers that are not finite become null
    outputs[output.name] = {{"unit", output.unit},
                            {"labels", output.labels},
                            {"values", std::vector<double>(values.begin(), values.end())}};
  }
  return {{"type", reading.info->type},
          {"time_s", static_cast<double>(reading.time.count()) / 1e9},
          {"samples", reading.samples},
          {"outputs", std::move(outputs)}};
}

double us(Duration duration) { return static_cast<double>(duration.count()) / 1e3; }

double us_per_call(const control_software::SoftwareReport& software) {
  return software.calls == 0 ? 0 : us(software.spent) / static_cast<double>(software.calls);
}

/// Null for software without messages.
json messages_object(const control_software::SoftwareReport& software) {
  if (!software.messages) return nullptr;
  const control_software::MessageCounts& counts = *software.messages;
  return {{"sent", counts.sent},         {"refused", counts.refused},
          {"lost", counts.lost},         {"arrived", counts.arrived},
          {"not_read", counts.not_read}, {"first_refused", software.first_refused_message}};
}

json way_object(const control_software::LinkCounts& counts) {
  return {{"sent", counts.sent},
          {"lost", counts.lost},
          {"overtaken", counts.overtaken},
          {"longest_ms", 1e3 * seconds(counts.longest)}};
}

json link_object(const control_software::SoftwareReport& software) {
  if (!software.link) return nullptr;
  return {{"signals", way_object(software.link->signals)}, {"commands", way_object(software.link->commands)}};
}

json control_object(const ControlReport& report) {
  const control_software::SoftwareReport& software = report.software;
  json said = json::array();
  for (const auto& message : software.said) said.push_back({{"time_s", seconds(message.time)}, {"text", message.text}});
  json changed = json::array();
  for (const auto& each : software.changed) {
    changed.push_back({{"what", each.what}, {"times", each.times}, {"first_s", seconds(each.first)}});
  }
  return {{"robot", report.robot},
          {"software", software.software},
          {"rate_hz", software.rate_hz},
          {"calls", software.calls},
          {"us_per_call", us_per_call(software)},
          {"worst_us", us(software.worst)},
          {"worst_at_s", seconds(software.worst_at)},
          {"budget_us", software.budget > Duration{} ? json(us(software.budget)) : json()},
          {"over_budget", software.over_budget},
          {"refused", software.refused},
          {"first_refusal", software.first_refusal},
          {"messages", messages_object(software)},
          {"link", link_object(software)},
          {"changed", std::move(changed)},
          {"ended", software.ended},
          {"said", std::move(said)},
          {"not_kept", software.not_kept}};
}

/// Columns for robots with messages only.
std::string message_text(const std::vector<ControlReport>& control) {
  std::string text;
  for (const auto& [robot, software] : control) {
    if (!software.messages) continue;
    if (text.empty()) {
      text = fmt::format("\n{:<12} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "messages of", "sent", "refused", "lost",
                         "arrived", "not read");
    }
    const control_software::MessageCounts& counts = *software.messages;
    text += fmt::format("{:<12} {:>8} {:>8} {:>8} {:>8} {:>8}\n", robot, counts.sent, counts.refused, counts.lost,
                        counts.arrived, counts.not_read);
  }
  return text;
}

std::string link_text(const std::vector<ControlReport>& control) {
  std::string text;
  for (const auto& [robot, software] : control) {
    if (!software.link) continue;
    if (text.empty()) {
      text = fmt::format("\n{:<12} {:<9} {:>8} {:>8} {:>9} {:>13}\n", "link of", "", "sent", "lost", "overtaken",
                         "the longest");
    }
    const auto way = [&](std::string_view what, const control_software::LinkCounts& counts) {
      text += fmt::format("{:<12} {:<9} {:>8} {:>8} {:>9} {:>10.1f} ms\n", robot, what, counts.sent, counts.lost,
                          counts.overtaken, 1e3 * seconds(counts.longest));
    };
    way("signals", software.link->signals);
    way("commands", software.link->commands);
  }
  return text;
}

/// A table, followed by the output lines of the software.
std::string control_text(const std::vector<ControlReport>& control) {
  if (control.empty()) return {};
  std::string text = fmt::format("\n{:<12} {:>9} {:>8} {:>13} {:>13} {:>11} {:>8}  {}\n", "control of", "rate", "calls",
                                 "time a call", "the longest", "over budget", "refused", "software");
  for (const auto& [robot, software] : control) {
    text += fmt::format("{:<12} {:>6.0f} Hz {:>8} {:>10.2f} us {:>10.2f} us {:>11} {:>8}  {}\n", robot,
                        software.rate_hz, software.calls, us_per_call(software), us(software.worst),
                        software.over_budget, software.refused, software.software);
  }
  for (const auto& [robot, software] : control) {
    for (const auto& message : software.said) {
      text += fmt::format("{:.3f} s: {} says: {}\n", seconds(message.time), robot, message.text);
    }
    if (software.not_kept > 0) text += fmt::format("{} says {} things more\n", robot, software.not_kept);
  }
  return text;
}

std::string sensor_line(const std::vector<SensorReport>& sensors) {
  if (sensors.empty()) return {};
  std::uint64_t samples = 0;
  for (const SensorReport& sensor : sensors) samples += sensor.reading.samples;
  return fmt::format("{} sensor{}, {} samples\n", sensors.size(), sensors.size() == 1 ? "" : "s", samples);
}

json stop_object(const RunReport& report) {
  if (!report.stopped) return nullptr;
  return {{"time_s", report.simulated}, {"by", report.stopped->by}, {"asked_s", report.stopped->asked}};
}

}  // namespace

std::string to_text(const RunReport& report) {
  std::string text = fmt::format("{:<12} {:<20} {:<20} {:<12} {:>9} {:>8} {:>6} {:>18}\n", "entity", "level", "contact",
                                 "controller", "walked", "", "falls", "position");
  for (const EntityReport& e : report.entities) {
    text += fmt::format("{:<12} {:<20} {:<20} {:<12} {:>7.2f} m {:>8} {:>6} {:>8.2f} {:>8.2f} m\n", e.name, e.level,
                        e.contact.empty() ? "-" : e.contact, e.controller.empty() ? "-" : e.controller, e.distance,
                        e.present ? e.frozen ? "frozen" : "" : "absent", e.falls, e.position.x, e.position.y);
  }
  text += fmt::format("\n{:<22} {:>9} {:>10} {:>12}\n", "algorithm", "rate", "calls", "time a call");
  for (const AlgorithmStatistics& a : report.algorithms) {
    text += fmt::format("{:<22} {:>6.0f} Hz {:>10} {:>9.2f} us\n", a.name, a.rate_hz, a.calls, a.us_per_call);
  }
  text += control_text(report.control);
  text += message_text(report.control);
  text += link_text(report.control);
  text += fmt::format("\n{:.2f} s simulated in {:.3f} s: {:.0f} times real time on {} thread{}\n", report.simulated,
                      report.wall, report.real_time_factor, report.threads, report.threads == 1 ? "" : "s");
  if (report.stopped) {
    text += fmt::format("stopped by {} at {:.3f} s of {:.3f} s\n", report.stopped->by, report.simulated,
                        report.stopped->asked);
  }
  text += fmt::format("seed {}, state hash {:016x}\n", report.seed, report.state_hash);
  text += sensor_line(report.sensors);
  if (report.drawings) {
    text += fmt::format("drawings for RoboViz: {} packets, {} of them ignored\n", report.drawings->packets,
                        report.drawings->ignored);
  }
  for (const Event& event : report.events) text += fmt::format("{:.3f} s: {}\n", seconds(event.time), event.text);
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  for (const std::string& warning : report.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

std::string to_json(const RunReport& report) {
  json root{{"schema", files::json_schema("run")},
            {"scene", report.scene},
            {"simulated_s", report.simulated},
            {"wall_s", report.wall},
            {"real_time_factor", report.real_time_factor},
            {"threads", report.threads},
            {"seed", report.seed},
            {"state_hash", fmt::format("{:016x}", report.state_hash)},
            {"stopped", stop_object(report)},
            {"entities", json::array()},
            {"sensors", json::object()},
            {"control", json::array()},
            {"drawings", json_of(report.drawings)},
            {"algorithms", json::array()},
            {"events", json::array()},
            {"notes", report.notes},
            {"warnings", report.warnings}};
  for (const EntityReport& e : report.entities) root["entities"].push_back(entity_object(e));
  for (const SensorReport& sensor : report.sensors) {
    root["sensors"][sensor.entity][sensor.reading.info->name] = sensor_object(sensor.reading);
  }
  for (const ControlReport& control : report.control) root["control"].push_back(control_object(control));
  for (const AlgorithmStatistics& a : report.algorithms) root["algorithms"].push_back(algorithm_object(a));
  for (const Event& event : report.events) {
    root["events"].push_back({{"time_s", seconds(event.time)}, {"text", event.text}});
  }
  return root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace murosimf::scene
