// The comparison as tables, for --details.
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/studies/compare_outcome.h"
#include "murosimf/studies/compare_report.h"
#include "murosimf/studies/compare_sensors.h"

namespace murosimf::studies {
namespace {

std::string law(const CompareEntry& entry) { return entry.contact.empty() ? "-" : entry.contact; }

std::string front(const CompareEntry& e) { return fmt::format("{:<20} {:<19}", e.level, law(e)); }

/// "1, 0.52 s": how often, and when first.
std::string falls(const Measures& m) {
  if (m.falls == 0) return "0";
  return fmt::format("{}, {:.2f} s", m.falls, first_fall(m.events));
}

std::string servos(const CompareEntry& e) {
  if (!e.frozen.empty()) return "frozen";
  if (e.traits.servos) return fmt::format("{:.0f} % full", 100 * e.record.full_duty);
  return e.overload.empty() ? "-" : "too weak";
}

std::string happened(const CompareEntry& e, double reference_cost) {
  if (!e.ran()) return fmt::format("{} {}\n", front(e), e.why_not());
  const Measures& m = e.measures;
  const std::string torque = m.peak_joint.empty() ? "-" : fmt::format("{:.2f} Nm", m.peak_torque);
  const bool timed = e.cost > 0 && reference_cost > 0;
  const std::string cost =
      timed ? fmt::format("{:>9.0f} {:>5.2f}", e.cost, e.cost / reference_cost) : "        -     -";
  return fmt::format("{} {} {:>5.2f} m {:>5.3f} m {:>5.3f} m {:>10} {:>9} {:>6.2f} {:>5.2f} m  {}\n", front(e), cost,
                     m.path_length, m.slip, m.clearance, torque, falls(m), m.end.x, m.end.y, servos(e));
}

std::string happened(const Comparison& c) {
  MUROSIMF_ASSERT(c.reference < c.entries.size());
  std::string text =
      fmt::format("\n{:<20} {:<19} {:>9} {:>5} {:>7} {:>7} {:>7} {:>10} {:>9} {:>14}  {}\n", "level", "contact",
                  "us per s", "cost", "path", "slip", "lift", "torque", "falls", "ends at", "servos");
  for (const CompareEntry& entry : c.entries) text += happened(entry, c.entries[c.reference].cost);
  return text;
}

/// Names of all that the robot has touched in any of the runs.
std::set<std::string> touched_in_any(const Comparison& c) {
  std::set<std::string> names;
  for (const CompareEntry& e : c.entries) {
    for (std::string& name : touched(e.outcome)) names.insert(std::move(name));
  }
  return names;
}

/// What the robot has touched: its way, speed and falls in each run.
std::string happened_to_others(const Comparison& c) {
  std::string rows;
  for (const std::string& name : touched_in_any(c)) {
    for (const CompareEntry& e : c.entries) {
      const auto other = std::ranges::find(e.outcome.others, name, &OtherRecord::name);
      if (other == e.outcome.others.end()) continue;
      const OtherMeasures m = measures_of(*other);
      const std::string when = other->touched ? fmt::format("{:.2f} s", *other->touched) : "never";
      rows += fmt::format("{:<20} {:<19} {:<15} {:>7} {:>5.2f} m {:>6.2f} m/s {:>7} {:>6.2f} {:>5.2f} m\n", e.level,
                          law(e), name, when, m.way, m.peak_speed, other->can_fall ? fmt::format("{}", m.falls) : "-",
                          m.end.x, m.end.y);
    }
  }
  if (rows.empty()) return {};
  return fmt::format("\n{:<20} {:<19} {:<15} {:>7} {:>7} {:>10} {:>7} {:>14}\n", "level", "contact", "it touches",
                     "first", "path", "fastest", "falls", "ends at") +
         rows;
}

/// What inertial sensors have shown up to where they are compared.
std::string happened_to_sensors(const Comparison& c) {
  std::string rows;
  for (const CompareEntry& e : c.entries) {
    for (const InertialRecord& record : e.sensors) {
      const InertialMeasures m = measures_of(record, e.compared_until);
      const auto number = [](bool has, double value, const char* unit) {
        return has ? fmt::format("{:.2f} {}", value, unit) : "-";
      };
      rows += fmt::format("{} {:<15} {:>11} {:>11} {:>11}\n", front(e), record.name,
                          number(record.accelerometer, m.force_rms, "m/s^2"),
                          number(record.accelerometer, m.force_peak, "m/s^2"),
                          number(record.gyroscope, m.rate_rms, "rad/s"));
    }
  }
  if (rows.empty()) return {};
  return fmt::format("\n{:<20} {:<19} {:<15} {:>11} {:>11} {:>11}\n", "level", "contact", "sensor", "|a|-g rms", "peak",
                     "|w| rms") +
         rows;
}

std::vector<ComparedQuantity> quantities_of(Concern concern) {
  std::vector<ComparedQuantity> all(quantities().begin(), quantities().end());
  std::erase_if(all, [&](const ComparedQuantity& q) { return q.concern != concern; });
  return all;
}

bool compared(const Comparison& c, std::size_t i) { return c.entries[i].ran() && i != c.reference; }

std::string deviated(const CompareEntry& e, const std::vector<ComparedQuantity>& all, bool torques) {
  std::string text = front(e);
  for (const ComparedQuantity& q : all) {
    text += fmt::format(" {:>{}}", number_of(q, q.of(e.deviations)), std::max<std::size_t>(12, q.name.size()));
  }
  const double torque = 100 * e.deviations.torque;
  if (torques) text += fmt::format(" {:>8}", std::isnan(torque) ? "-" : fmt::format("{:.0f} %", torque));
  return text + "\n";
}

/// How far levels are off the reference, in what concerns the robot, others or sensors.
std::string deviated(const Comparison& c, Concern concern) {
  const auto all = quantities_of(concern);
  const bool torques = concern == Concern::robot;
  std::string text = fmt::format("\n{:<20} {:<19}", "off the reference by", "");
  for (const ComparedQuantity& q : all)
    text += fmt::format(" {:>{}}", q.name, std::max<std::size_t>(12, q.name.size()));
  text += torques ? fmt::format(" {:>8}\n", "torque") : "\n";
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    if (compared(c, i)) text += deviated(c.entries[i], all, torques);
  }
  return text;
}

std::string judged(const CompareEntry& e, const LevelVerdict& verdict) {
  std::string text = verdict.adequate ? "adequate" : fmt::format("not adequate: {}", fmt::join(verdict.reasons, "; "));
  for (const std::string& diagnostic : verdict.diagnostics) text += fmt::format("; {}", diagnostic);
  return fmt::format("{} {}\n", front(e), text);
}

/// Those that can be compared with the reference: their deviations, then what follows from them.
std::string compared(const Comparison& c, const Recommendation& r) {
  const CompareEntry& reference = c.entries[c.reference];
  MUROSIMF_ASSERT(r.verdicts.size() == c.entries.size() && r.of_sensors.size() == c.entries.size());
  std::string words, sensors;
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    if (!compared(c, i)) continue;
    words += judged(c.entries[i], r.verdicts[i]);
    sensors += judged(c.entries[i], r.of_sensors[i]);
  }
  if (words.empty()) return {};
  std::string text = deviated(c, Concern::robot);
  if (!reference.outcome.others.empty()) text += deviated(c, Concern::others);
  if (!reference.sensors.empty()) text += deviated(c, Concern::sensors);
  text += "\n" + words;
  return reference.sensors.empty() ? text : text + "\nsensors:\n" + sensors;
}

}  // namespace

std::string details(const Comparison& comparison, const Recommendation& recommendation) {
  std::string text = happened(comparison) + happened_to_others(comparison) + happened_to_sensors(comparison) +
                     compared(comparison, recommendation);
  std::string last;
  for (const CompareEntry& entry : comparison.entries) {
    if (!entry.overload.empty()) last += fmt::format("{}: {}\n", label(comparison, entry), entry.overload);
  }
  for (const std::string& need : recommendation.needs) last += need + "\n";
  return last.empty() ? text : text + "\n" + last;
}

}  // namespace murosimf::studies
