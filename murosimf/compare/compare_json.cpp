// The comparison as JSON.
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "murosimf/compare/compare_report.h"
#include "murosimf/files/json_schema.h"

namespace murosimf::compare {
namespace {

toml::array events_array(const Measures& measures) {
  toml::array events;
  for (const PostureEvent& event : measures.events) {
    events.push_back(toml::table{{"time_s", event.time}, {"posture", event.down ? "down" : "up"}});
  }
  return events;
}

toml::table deviations_table(const Deviations& deviations) {
  toml::table table;
  for (const ComparedQuantity& q : quantities()) table.insert(q.name, q.of(deviations));
  if (!std::isnan(deviations.torque)) table.insert("torque", 100 * deviations.torque);
  return table;
}

toml::table entry_table(const Comparison& c, std::size_t i) {
  const CompareEntry& e = c.entries[i];
  toml::table table{{"level", e.level}, {"contact", e.contact}, {"ran", e.ran()}, {"reference", i == c.reference}};
  if (!e.ran()) {
    table.insert("refusal", e.refusal);
    return table;
  }
  const Measures& m = e.measures;
  const double reference = c.entries[c.reference].cost;
  if (e.cost > 0) table.insert("cost_us_per_s", e.cost);
  if (e.cost > 0 && reference > 0) table.insert("cost_share", e.cost / reference);
  table.insert("path_length_m", m.path_length);
  table.insert("end_m", toml::array{m.end.x, m.end.y, m.end.z});
  table.insert("slip_m", m.slip);
  table.insert("torso_rate_rms_rad_s", m.rate);
  table.insert("clearance_m", m.clearance);
  table.insert("falls", m.falls);
  table.insert("events", events_array(m));
  if (!m.peak_joint.empty()) table.insert("peak_torque_Nm", m.peak_torque);
  if (!m.peak_joint.empty()) table.insert("peak_joint", m.peak_joint);
  if (e.level == "articulated_dynamics") table.insert("full_duty_share", e.record.full_duty);
  if (!e.overload.empty()) table.insert("overload", e.overload);
  if (!e.frozen.empty()) table.insert("frozen", e.frozen);
  table.insert("deviations", deviations_table(e.deviations));
  return table;
}

toml::table recommendation_table(const Comparison& c, const Recommendation& r) {
  toml::array levels;
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    toml::array reasons;
    for (const std::string& reason : r.verdicts[i].reasons) reasons.push_back(reason);
    levels.push_back(toml::table{{"level", c.entries[i].level},
                                 {"contact", c.entries[i].contact},
                                 {"adequate", r.verdicts[i].adequate},
                                 {"reasons", std::move(reasons)}});
  }
  return toml::table{{"sentence", r.sentence},
                     {"level", r.level},
                     {"contact", r.contact},
                     {"levels", std::move(levels)}};
}

}  // namespace

std::string to_json(const Comparison& c, const Recommendation& recommendation, const Thresholds& thresholds) {
  toml::table limits;
  for (std::size_t q = 0; q < thresholds.values.size(); ++q) limits.insert(quantities()[q].name, thresholds.values[q]);
  limits.insert("fall_time", thresholds.fall_time);
  toml::array entries;
  for (std::size_t i = 0; i < c.entries.size(); ++i) entries.push_back(entry_table(c, i));
  const toml::table root{{"schema", files::json_schema("compare")},
                         {"scene", c.scene},
                         {"entity", c.entity},
                         {"duration_s", c.duration},
                         {"seed", static_cast<std::int64_t>(c.seed)},
                         {"timed_runs", c.repeat},
                         {"stopped", c.stopped},
                         {"entries", std::move(entries)},
                         {"thresholds", std::move(limits)},
                         {"recommendation", recommendation_table(c, recommendation)}};
  std::stringstream stream;
  stream << toml::json_formatter(root) << "\n";
  return stream.str();
}

}  // namespace murosimf::compare
