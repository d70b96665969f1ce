/// run_report.h - the results of a run: for people as a table, for programs as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/control_software/software_report.h"
#include "murosimf/math/vec3.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::scene {

struct EntityReport {
  std::string name, model, level, contact, controller, team;
  Vec3d position;       ///< [m] of the base, world frame
  double distance = 0;  ///< [m]
  int falls = 0;
  bool frozen = false;
  bool present = true;
};

/// The last sample of a sensor.
struct SensorReport {
  std::string entity;
  sensors::Reading reading;
};

/// Control software of a robot.
struct ControlReport {
  std::string robot;
  control_software::SoftwareReport software;
};

/// Early end of a run.
struct EarlyStop {
  std::string by;    ///< "SIGINT"
  double asked = 0;  ///< [s] requested simulated time
};

/// Packets with drawings of other programs (drawing/roboviz_server.h).
struct DrawingPackets {
  std::uint64_t packets = 0;
  std::uint64_t ignored = 0;  ///< damaged or excess ones among them
};

struct RunReport {
  std::string scene;
  double simulated = 0;  ///< [s]
  double wall = 0;       ///< [s]
  double real_time_factor = 0;
  int threads = 1;
  std::uint64_t seed = 0;
  std::uint64_t state_hash = 0;
  std::optional<EarlyStop> stopped;  ///< at `simulated`; nothing: the run was completed
  std::vector<EntityReport> entities;
  std::vector<SensorReport> sensors;
  std::vector<ControlReport> control;
  std::optional<DrawingPackets> drawings;  ///< nothing: no server was open
  std::vector<AlgorithmStatistics> algorithms;
  std::vector<Event> events;
  std::vector<std::string> notes;     ///< limits of a level: nothing is wrong
  std::vector<std::string> warnings;  ///< problems that may make the result worthless
};

/// Tables with aligned columns: entities, algorithms, sums, events, notes, warnings. Of sensors only their number.
[[nodiscard]] std::string to_text(const RunReport& report);

/// One JSON object: schema (json_document.h), simulated_s, wall_s, real_time_factor, threads, seed, state_hash (hexadecimal text),
/// stopped (null, or {time_s, by, asked_s} if a signal ended the run early),
/// entities [{name, model, level, contact, controller, team, position, distance_m, falls, frozen, present}],
/// sensors {entity: {sensor: {type, time_s, samples, outputs: {name: {unit, labels, values}}}}} with null for what is no
/// finite number, control [{robot, software, rate_hz, calls, us_per_call, worst_us, worst_at_s, budget_us (null: any), over_budget,
/// refused, first_refusal, changed (list of {what, times, first_s}), messages (null: none; or {sent, refused, lost, arrived, not_read, first_refused}),
/// link (null: none; or signals and commands: {sent, lost, overtaken, longest_ms}), ended, said [{time_s, text}], not_kept}], drawings (null, or {packets,
/// ignored}), algorithms [{name, rate_hz, calls, us_per_call}], events [{time_s, text}], notes [], warnings [].
[[nodiscard]] std::string to_json(const RunReport& report);

}  // namespace murosimf::scene
