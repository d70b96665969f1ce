// The comparison as JSON.
#include <cmath>

#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/math/assert.h"
#include "murosimf/studies/compare_outcome.h"
#include "murosimf/studies/compare_report.h"
#include "murosimf/studies/compare_seeds.h"
#include "murosimf/studies/compare_sensors.h"

namespace murosimf::studies {
namespace {

using nlohmann::json;

json events_array(const Measures& measures) {
  json events = json::array();
  for (const PostureEvent& event : measures.events) {
    events.push_back({{"time_s", event.time}, {"posture", event.down ? "down" : "up"}});
  }
  return events;
}

json others_array(const OutcomeRecord& outcome) {
  json others = json::array();
  for (const OtherRecord& other : outcome.others) {
    const OtherMeasures m = measures_of(other);
    json object{{"name", other.name},
                {"path_length_m", m.way},
                {"peak_speed_m_s", m.peak_speed},
                {"end_m", {m.end.x, m.end.y, m.end.z}},
                {"touched_s", nullptr}};
    if (other.touched) object["touched_s"] = *other.touched;
    if (other.can_fall) object["falls"] = m.falls;
    others.push_back(std::move(object));
  }
  return others;
}

json sensors_array(const CompareEntry& entry) {
  json sensors = json::array();
  for (const InertialRecord& record : entry.sensors) {
    const InertialMeasures m = measures_of(record, entry.compared_until);
    json object{{"name", record.name}};
    if (record.accelerometer) object["accelerometer_rms_m_s2"] = m.force_rms;
    if (record.accelerometer) object["accelerometer_peak_m_s2"] = m.force_peak;
    if (record.gyroscope) object["gyroscope_rms_rad_s"] = m.rate_rms;
    sensors.push_back(std::move(object));
  }
  return sensors;
}

json outcomes_object(const Comparison& c, const CompareEntry& entry, const Thresholds& thresholds) {
  json object = json::object();
  for (const NamedOutcome& outcome : c.outcomes) {
    const OutcomeOff off = outcome_off(outcome, entry, c.entries[c.reference], thresholds);
    object[outcome.name()] = {{"within", off.reason.empty()}};
    // Falls and touches have no number.
    if (!std::isnan(off.value)) object[outcome.name()]["off"] = off.value;
  }
  return object;
}

json deviations_object(const Deviations& deviations) {
  json object = json::object();
  for (const ComparedQuantity& q : quantities()) object[q.name] = q.of(deviations);
  if (!std::isnan(deviations.torque)) object["torque"] = 100 * deviations.torque;
  return object;
}

json entry_object(const Comparison& c, std::size_t i, const Thresholds& thresholds) {
  MUROSIMF_ASSERT(i < c.entries.size() && c.reference < c.entries.size());
  const CompareEntry& e = c.entries[i];
  json object{{"level", e.level}, {"contact", e.contact}, {"ran", e.ran()}, {"reference", i == c.reference}};
  if (!e.ran()) {
    object["refusal"] = e.refusal;
    return object;
  }
  const Measures& m = e.measures;
  const double reference = c.entries[c.reference].cost;
  if (e.cost > 0) object["cost_us_per_s"] = e.cost;
  if (e.cost > 0 && reference > 0) object["cost_share"] = e.cost / reference;
  object["path_length_m"] = m.path_length;
  object["end_m"] = {m.end.x, m.end.y, m.end.z};
  object["slip_m"] = m.slip;
  object["torso_rate_rms_rad_s"] = m.rate;
  object["clearance_m"] = m.clearance;
  object["falls"] = m.falls;
  object["events"] = events_array(m);
  if (!m.peak_joint.empty()) object["peak_torque_Nm"] = m.peak_torque;
  if (!m.peak_joint.empty()) object["peak_joint"] = m.peak_joint;
  if (e.traits.servos) object["full_duty_share"] = e.record.full_duty;
  if (!e.overload.empty()) object["overload"] = e.overload;
  if (!e.frozen.empty()) object["frozen"] = e.frozen;
  object["others"] = others_array(e.outcome);
  object["sensors"] = sensors_array(e);
  object["deviations"] = deviations_object(e.deviations);
  object["outcomes"] = outcomes_object(c, e, thresholds);
  // JSON has no infinity: a run without a fall is compared up to its end.
  object["compared_until_s"] = std::isinf(e.compared_until) ? c.end : e.compared_until;
  return object;
}

json recommendation_object(const Comparison& c, const Recommendation& r) {
  MUROSIMF_ASSERT(r.verdicts.size() == c.entries.size() && r.of_sensors.size() == c.entries.size());
  json levels = json::array();
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    levels.push_back({{"level", c.entries[i].level},
                      {"contact", c.entries[i].contact},
                      {"adequate", r.verdicts[i].adequate},
                      {"reasons", r.verdicts[i].reasons},
                      {"diagnostics", r.verdicts[i].diagnostics},
                      {"adequate_sensors", r.of_sensors[i].adequate},
                      {"sensor_reasons", r.of_sensors[i].reasons}});
  }
  return {{"sentence", r.sentence}, {"verdict", r.verdict}, {"needs", r.needs},           {"sensors", r.sensors},
          {"level", r.level},       {"contact", r.contact}, {"levels", std::move(levels)}};
}

/// Thresholds are part of it: verdicts cannot be understood without them.
json document(const Comparison& c, const Recommendation& recommendation, const Thresholds& thresholds) {
  MUROSIMF_ASSERT(thresholds.values.size() == quantities().size());
  json limits;
  for (std::size_t q = 0; q < thresholds.values.size(); ++q) limits[quantities()[q].name] = thresholds.values[q];
  limits["fall_time"] = thresholds.fall_time;
  limits["contact_duty"] = thresholds.contact_duty;
  json entries = json::array();
  for (std::size_t i = 0; i < c.entries.size(); ++i) entries.push_back(entry_object(c, i, thresholds));
  return {{"schema", files::json_schema("compare")},
          {"scene", c.scene},
          {"entity", c.entity},
          {"start_s", c.start},
          {"end_s", c.end},
          {"seed", c.seed},
          {"timed_runs", c.repeat},
          {"stopped", c.stopped},
          {"entries", std::move(entries)},
          {"thresholds", std::move(limits)},
          {"recommendation", recommendation_object(c, recommendation)}};
}

json seeds_verdict(const SeedsVerdict& verdict) {
  return {{"name", verdict.name},
          {"adequate", verdict.adequate},
          {"reasons", verdict.reasons},
          {"share", verdict.share.mean},
          {"low_95", verdict.share.low},
          {"high_95", verdict.share.high},
          {"judgement", to_string(verdict.judgement)}};
}

/// The reference has no verdict: it is what the others are compared with.
json seeds_object(const SeedsComparison& s) {
  MUROSIMF_ASSERT(s.levels.size() == s.first.entries.size());
  json levels = json::array(), yardstick = nullptr;
  for (std::size_t i = 0; i < s.levels.size(); ++i) {
    if (i != s.first.reference) levels.push_back(seeds_verdict(s.levels[i]));
  }
  for (const SeedsVerdict& verdict : s.yardstick) yardstick = seeds_verdict(verdict);
  return {{"first", s.seed},
          {"count", s.seeds()},
          {"seeds_differ", s.seeds_differ},
          {"servo_tolerance_percent", 100 * s.servo_tolerance},
          {"verdict", s.verdict},
          {"levels", std::move(levels)},
          {"yardstick", std::move(yardstick)}};
}

}  // namespace

std::string to_json(const Comparison& c, const Recommendation& recommendation, const Thresholds& thresholds) {
  return files::json_text(document(c, recommendation, thresholds));
}

std::string to_json(const SeedsComparison& s, const Thresholds& thresholds) {
  json all = document(s.first, s.of_first, thresholds);
  all["seeds"] = seeds_object(s);
  return files::json_text(all);
}

}  // namespace murosimf::studies
