// The comparison in a few lines.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/compare/compare_outcome.h"
#include "murosimf/compare/compare_report.h"

namespace murosimf::compare {
namespace {

constexpr std::size_t reasons_shown = 2;

std::string cost(const Comparison& c, const CompareEntry& entry) {
  const double reference = c.entries[c.reference].cost;
  return entry.cost > 0 && reference > 0 ? fmt::format("cost {:.2f}", entry.cost / reference) : "cost -   ";
}

std::string why_not(const std::vector<std::string>& reasons) {
  const std::size_t shown = std::min(reasons.size(), reasons_shown);
  std::string text = fmt::format("{}", fmt::join(reasons.begin(), reasons.begin() + static_cast<long>(shown), "; "));
  return reasons.size() > shown ? text + fmt::format("; and {} more", reasons.size() - shown) : text;
}

std::string line_of(const Comparison& c, const CompareEntry& entry, const LevelVerdict& verdict, std::size_t width) {
  const std::string judged = verdict.adequate ? "adequate" : "not adequate: " + why_not(verdict.reasons);
  return fmt::format("  {:<{}}  {}  {}\n", label(c, entry), width, cost(c, entry), judged);
}

std::string span_of(const Comparison& c) {
  return c.start > 0 ? fmt::format("from {:g} to {:g} s", c.start, c.end) : fmt::format("for {:g} s", c.end);
}

/// "its motion, ball and crate", or what was named.
std::string subject(const Comparison& c) {
  std::vector<std::string> named;
  for (const NamedOutcome& outcome : c.outcomes) named.push_back(outcome.name());
  if (!named.empty()) return fmt::format("{} alone", fmt::join(named, ", "));
  const auto others = touched(c.entries[c.reference].outcome);
  return others.empty() ? "its motion, and what is around"
                        : fmt::format("its motion, and what is around (it touches {})", fmt::join(others, ", "));
}

std::string compared(const Comparison& c) {
  const CompareEntry& reference = c.entries[c.reference];
  const double fall = reference.compared_until;
  const std::string until = std::isinf(fall) || !c.outcomes.empty()
                                ? ""
                                : fmt::format("; before it begins to fall at {:.2f} s, then falls and touches", fall);
  return fmt::format("compared with {}: {} {}, seed {}; {}{}\n", label(c, reference), c.entity, span_of(c), c.seed,
                     subject(c), until);
}

}  // namespace

std::string summary(const Comparison& c, const Recommendation& r) {
  std::string text = fmt::format("{}: {}\n", c.scene, r.verdict);
  std::size_t width = 0;
  for (const CompareEntry& entry : c.entries) width = std::max(width, label(c, entry).size());
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    if (i != c.reference) text += line_of(c, c.entries[i], r.verdicts[i], width);
  }
  text += compared(c);
  if (!r.sensors.empty()) text += fmt::format("for what reads inertial sensors: {}\n", r.sensors);
  return text;
}

}  // namespace murosimf::compare
