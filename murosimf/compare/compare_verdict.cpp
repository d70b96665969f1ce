#include "murosimf/compare/compare_verdict.h"

#include <cmath>

#include <fmt/format.h>

namespace murosimf::compare {
namespace {

std::string times(int count) { return count == 1 ? "once" : fmt::format("{} times", count); }

std::string different_falls(int mine, int reference) {
  if (mine == 0) return "does not fall, the reference does";
  if (reference == 0) return fmt::format("falls {}, the reference does not", times(mine));
  return fmt::format("falls {}, the reference {}", times(mine), times(reference));
}

/// How the falls of a run differ from the reference's; empty: they do not.
std::string event_difference(const Measures& mine, const Measures& reference, double tolerance) {
  const auto &ours = mine.events, &theirs = reference.events;
  if (ours.empty() || theirs.empty()) return "nothing was recorded";
  if (ours[0].down != theirs[0].down) {
    return ours[0].down ? "begins lying, the reference upright" : "begins upright, the reference lying";
  }
  if (mine.falls != reference.falls) return different_falls(mine.falls, reference.falls);
  if (ours.size() != theirs.size()) {
    return ours.size() < theirs.size() ? "does not get up, the reference does" : "gets up, the reference does not";
  }
  for (std::size_t i = 1; i < ours.size(); ++i) {
    const double later = ours[i].time - theirs[i].time;
    if (std::abs(later) <= tolerance) continue;
    return fmt::format("{} {:.2f} s {} than the reference", ours[i].down ? "falls" : "gets up", std::abs(later),
                       later > 0 ? "later" : "earlier");
  }
  return {};
}

}  // namespace

LevelVerdict judge(const CompareEntry& entry, const CompareEntry& reference, const Thresholds& thresholds) {
  LevelVerdict verdict;
  if (!entry.ran()) {
    verdict.reasons.push_back(entry.why_not());
    return verdict;
  }
  if (!entry.frozen.empty()) verdict.reasons.push_back("froze: " + entry.frozen);
  auto difference = event_difference(entry.measures, reference.measures, thresholds.fall_time);
  if (!difference.empty()) verdict.reasons.push_back(std::move(difference));
  for (std::size_t q = 0; reference.measures.falls == 0 && q < quantities().size(); ++q) {
    const ComparedQuantity& quantity = quantities()[q];
    const double value = quantity.of(entry.deviations);
    if (value <= thresholds.values[q]) continue;  // NaN is not
    verdict.reasons.push_back(
        fmt::format("{} {} off, more than {:g}", quantity.words, number_of(quantity, value), thresholds.values[q]));
  }
  verdict.adequate = verdict.reasons.empty();
  return verdict;
}

}  // namespace murosimf::compare
