#include "murosimf/studies/compare_verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/studies/compare_outcome.h"

namespace murosimf::studies {
namespace {

/// Servos give way to what the robot touches; levels without servos do not show that. Whether it matters, the outcome decides: servos
/// of a robot that walks give all they have in half of the time anyway.
std::string missing_servos(const CompareEntry& entry, const CompareEntry& reference, double limit) {
  if (entry.traits.servos || !reference.traits.servos) return {};
  const double duty = 100 * duty_while_touching(reference.record, reference.outcome);
  if (duty <= limit) return {};
  return fmt::format(
      "has no servos; the reference's give all they have in {:.0f} % of the time around its touches of {} ({:.0f} % of "
      "all time)",
      duty, fmt::join(touched(reference.outcome), ", "), 100 * reference.record.full_duty);
}

void add(std::vector<std::string> lines, std::vector<std::string>& all) {
  for (std::string& line : lines) {
    if (!line.empty()) all.push_back(std::move(line));
  }
}

/// The effects of the robot on others.
void judge_outcome(const CompareEntry& entry, const CompareEntry& reference, const Thresholds& thresholds,
                   std::vector<std::string>& reasons) {
  add(different_touches(entry.outcome, reference.outcome), reasons);
  add(different_falls_of_others(entry.outcome, reference.outcome, thresholds.fall_time), reasons);
}

std::vector<std::string> not_comparable(const CompareEntry& entry, const CompareEntry& reference) {
  if (!entry.ran()) return {entry.why_not()};
  return {entry.frozen.empty() ? "" : "froze: " + entry.frozen, reference.frozen.empty() ? "" : "the reference froze"};
}

/// What is over its threshold, the worst first.
std::vector<std::string> excesses(const Deviations& deviations, const Thresholds& thresholds, bool of_sensors) {
  std::vector<std::pair<double, std::string>> found;
  MUROSIMF_ASSERT(thresholds.values.size() == quantities().size());
  for (std::size_t q = 0; q < quantities().size(); ++q) {
    const ComparedQuantity& quantity = quantities()[q];
    if ((quantity.concern == Concern::sensors) != of_sensors) continue;
    const double value = quantity.of(deviations), limit = thresholds.values[q];
    if (value <= limit) continue;  // NaN is not
    const std::string& owner = quantity.owner(deviations);
    // NaN has no rank: it counts as the largest excess.
    found.emplace_back(std::isnan(value) ? std::numeric_limits<double>::infinity() : value / limit,
                       fmt::format("{} {} off, more than {:g}{}", quantity.words, number_of(quantity, value), limit,
                                   owner.empty() ? "" : " (" + owner + ")"));
  }
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> lines;
  for (auto& [times, line] : found) lines.push_back(std::move(line));
  return lines;
}

}  // namespace

LevelVerdict judge_sensors(const CompareEntry& entry, const CompareEntry& reference, const Thresholds& thresholds) {
  LevelVerdict verdict;
  add(not_comparable(entry, reference), verdict.reasons);
  if (entry.ran()) {  // a fall is what they show first of all
    add({difference(entry.measures.events, reference.measures.events, thresholds.fall_time)}, verdict.reasons);
    add(excesses(entry.deviations, thresholds, true), verdict.reasons);
  }
  verdict.adequate = verdict.reasons.empty();
  return verdict;
}

LevelVerdict judge(const CompareEntry& entry, const CompareEntry& reference, const Thresholds& thresholds,
                   const std::vector<NamedOutcome>& outcomes) {
  LevelVerdict verdict;
  add(not_comparable(entry, reference), verdict.reasons);
  if (!entry.ran()) return verdict;
  if (outcomes.empty()) {
    add({difference(entry.measures.events, reference.measures.events, thresholds.fall_time)}, verdict.reasons);
    judge_outcome(entry, reference, thresholds, verdict.reasons);
    add(excesses(entry.deviations, thresholds, false), verdict.reasons);
  }
  for (const NamedOutcome& outcome : outcomes) {
    add({outcome_off(outcome, entry, reference, thresholds).reason}, verdict.reasons);
  }
  add({missing_servos(entry, reference, thresholds.contact_duty)}, verdict.diagnostics);
  verdict.adequate = verdict.reasons.empty();
  return verdict;
}

}  // namespace murosimf::studies
