#include "murosimf/compare/compare_verdict.h"

#include <fmt/format.h>

#include "murosimf/compare/compare_outcome.h"

namespace murosimf::compare {
namespace {

/// What servos do that a level has none of: they give way to what the robot touches.
std::string missing_servos(const CompareEntry& entry, const CompareEntry& reference, double limit) {
  if (entry.traits.servos || !reference.traits.servos) return {};
  const double duty = 100 * duty_while_touching(reference.record, reference.outcome);
  if (duty <= limit) return {};
  return fmt::format(
      "has no servos, and the reference's give all they have in {:.0f} % of the time around its touches of {}", duty,
      fmt::join(touched(reference.outcome), ", "));
}

void add(std::vector<std::string> lines, std::vector<std::string>& reasons) {
  for (std::string& line : lines) {
    if (!line.empty()) reasons.push_back(std::move(line));
  }
}

/// What the robot has done to others.
void judge_outcome(const CompareEntry& entry, const CompareEntry& reference, const Thresholds& thresholds,
                   std::vector<std::string>& reasons) {
  add(different_touches(entry.outcome, reference.outcome), reasons);
  add(different_falls_of_others(entry.outcome, reference.outcome, thresholds.fall_time), reasons);
}

}  // namespace

LevelVerdict judge(const CompareEntry& entry, const CompareEntry& reference, const Thresholds& thresholds) {
  LevelVerdict verdict;
  if (!entry.ran()) {
    verdict.reasons.push_back(entry.why_not());
    return verdict;
  }
  if (!entry.frozen.empty()) verdict.reasons.push_back("froze: " + entry.frozen);
  if (!reference.frozen.empty()) verdict.reasons.emplace_back("the reference froze");
  add({difference(entry.measures.events, reference.measures.events, thresholds.fall_time)}, verdict.reasons);
  judge_outcome(entry, reference, thresholds, verdict.reasons);
  const bool fell = reference.measures.falls > 0;
  if (!fell) add({missing_servos(entry, reference, thresholds.contact_duty)}, verdict.reasons);
  for (std::size_t q = 0; !fell && q < quantities().size(); ++q) {
    const ComparedQuantity& quantity = quantities()[q];
    const double value = quantity.of(entry.deviations);
    if (value <= thresholds.values[q]) continue;  // NaN is not
    const std::string& who = quantity.who(entry.deviations);
    verdict.reasons.push_back(fmt::format("{} {} off, more than {:g}{}", quantity.words, number_of(quantity, value),
                                          thresholds.values[q], who.empty() ? "" : " (" + who + ")"));
  }
  verdict.adequate = verdict.reasons.empty();
  return verdict;
}

}  // namespace murosimf::compare
