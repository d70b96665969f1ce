// The comparison as tables.
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "murosimf/compare/compare_outcome.h"
#include "murosimf/compare/compare_report.h"

namespace murosimf::compare {
namespace {

std::string law(const CompareEntry& entry) { return entry.contact.empty() ? "-" : entry.contact; }

std::string head(const Comparison& c) {
  const std::string span =
      c.start > 0 ? fmt::format("from {:g} to {:g} s", c.start, c.end) : fmt::format("for {:g} s", c.end);
  return fmt::format("{}: {} {}, seed {}; reference: {}\n", c.scene, c.entity, span, c.seed,
                     label(c, c.entries[c.reference]));
}

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
  const std::string front = fmt::format("{:<20} {:<19}", e.level, law(e));
  if (!e.ran()) return fmt::format("{} {}\n", front, e.why_not());
  const Measures& m = e.measures;
  const std::string torque = m.peak_joint.empty() ? "-" : fmt::format("{:.2f} Nm", m.peak_torque);
  const bool timed = e.cost > 0 && reference_cost > 0;
  const std::string cost =
      timed ? fmt::format("{:>9.0f} {:>5.2f}", e.cost, e.cost / reference_cost) : "        -     -";
  return fmt::format("{} {} {:>5.2f} m {:>5.3f} m {:>5.3f} m {:>10} {:>9} {:>6.2f} {:>5.2f} m  {}\n", front, cost,
                     m.path_length, m.slip, m.clearance, torque, falls(m), m.end.x, m.end.y, servos(e));
}

std::string happened(const Comparison& c) {
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

/// What became of what the robot has touched.
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

/// Without those of others, if there are no others.
std::vector<ComparedQuantity> shown(const Comparison& c) {
  std::vector<ComparedQuantity> all(quantities().begin(), quantities().end());
  if (c.entries[c.reference].outcome.others.empty()) {
    std::erase_if(all, [](const ComparedQuantity& q) { return q.of_another != nullptr; });
  }
  return all;
}

std::string deviated(const CompareEntry& e, const std::vector<ComparedQuantity>& all) {
  std::string text = fmt::format("{:<20} {:<19}", e.level, law(e));
  for (const ComparedQuantity& q : all) text += fmt::format(" {:>12}", number_of(q, q.of(e.deviations)));
  const double torque = 100 * e.deviations.torque;
  return text + fmt::format(" {:>8}\n", std::isnan(torque) ? "-" : fmt::format("{:.0f} %", torque));
}

std::string judged(const CompareEntry& e, const LevelVerdict& verdict) {
  const std::string text =
      verdict.adequate ? "adequate" : fmt::format("not adequate: {}", fmt::join(verdict.reasons, "; "));
  return fmt::format("{:<20} {:<19} {}\n", e.level, law(e), text);
}

/// Those that can be compared with the reference: their deviations, then what follows from them.
std::string compared(const Comparison& c, const Recommendation& r) {
  std::string numbers = fmt::format("\n{:<20} {:<19}", "off the reference by", "");
  const auto all = shown(c);
  for (const ComparedQuantity& q : all) numbers += fmt::format(" {:>12}", q.name);
  numbers += fmt::format(" {:>8}\n", "torque");
  std::string words;
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    const CompareEntry& e = c.entries[i];
    if (!e.ran() || i == c.reference) continue;
    numbers += deviated(e, all);
    words += judged(e, r.verdicts[i]);
  }
  return words.empty() ? std::string{} : numbers + "\n" + words;
}

}  // namespace

std::string to_text(const Comparison& comparison, const Recommendation& recommendation) {
  std::string text = head(comparison) + happened(comparison) + happened_to_others(comparison) +
                     compared(comparison, recommendation) + "\n";
  for (const CompareEntry& entry : comparison.entries) {
    if (!entry.overload.empty()) text += fmt::format("{}: {}\n", label(comparison, entry), entry.overload);
  }
  return text + recommendation.sentence + "\n";
}

}  // namespace murosimf::compare
