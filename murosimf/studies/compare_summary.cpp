// The comparison in a few lines.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/studies/compare_outcome.h"
#include "murosimf/studies/compare_report.h"
#include "murosimf/studies/compare_seeds.h"

namespace murosimf::studies {
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

std::string compared(const Comparison& c, const std::string& seeds) {
  const CompareEntry& reference = c.entries[c.reference];
  const double fall = reference.compared_until;
  const std::string until = std::isinf(fall) || !c.outcomes.empty()
                                ? ""
                                : fmt::format("; before it begins to fall at {:.2f} s, then falls and touches", fall);
  return fmt::format("compared with {}: {} {}, {}; {}{}\n", label(c, reference), c.entity, span_of(c), seeds,
                     subject(c), until);
}

/// [characters] of the longest name, so that columns are aligned.
std::size_t width_of(const Comparison& c) {
  std::size_t width = 0;
  for (const CompareEntry& entry : c.entries) width = std::max(width, label(c, entry).size());
  return width;
}

/// "in 17 of 20 seeds (85 %, 64 to 95 % of all with a confidence of 95 %)"
std::string share_of(const SeedsVerdict& verdict) {
  const auto adequate = std::ranges::count(verdict.adequate, true);
  const std::string text = fmt::format("in {} of {} seeds", adequate, verdict.adequate.size());
  if (verdict.share.count < 2) return text;
  return fmt::format("{} ({:.0f} %, {:.0f} to {:.0f} % of all with a confidence of 95 %)", text,
                     100 * verdict.share.mean, 100 * verdict.share.low, 100 * verdict.share.high);
}

/// "; seed 3: falls once, the reference does not": the first one for which it is not adequate.
std::string example(const SeedsComparison& s, const SeedsVerdict& verdict) {
  MUROSIMF_ASSERT(verdict.reasons.size() == verdict.adequate.size());
  for (std::size_t i = 0; i < verdict.adequate.size(); ++i) {
    if (!verdict.adequate[i]) return fmt::format("; seed {}: {}", s.seed + i, verdict.reasons[i]);
  }
  return {};
}

std::string seeds_of(const SeedsComparison& s) {
  std::string text = fmt::format("seeds {} to {}", s.seed, s.seed + s.seeds() - 1);
  if (s.seeds() == 1) text = fmt::format("seed {}", s.seed);
  return s.servo_tolerance > 0 ? fmt::format("{}, gains of its servos within {:g} %", text, 100 * s.servo_tolerance)
                               : text;
}

}  // namespace

std::string summary(const SeedsComparison& s) {
  const Comparison& c = s.first;
  MUROSIMF_ASSERT(s.levels.size() == c.entries.size());
  std::string text = fmt::format("{}: {}\n", c.scene, s.verdict);
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    if (i == c.reference) continue;
    const SeedsVerdict& level = s.levels[i];
    text += fmt::format("  {:<{}}  {}  {}: {}{}\n", level.name, width_of(c), cost(c, c.entries[i]),
                        to_string(level.judgement), share_of(level), example(s, level));
  }
  for (const SeedsVerdict& yardstick : s.yardstick) {
    text += fmt::format("yardstick: {} {}{}\n", yardstick.name, share_of(yardstick), example(s, yardstick));
  }
  text += compared(c, seeds_of(s));
  if (s.seeds() > 1 && !s.seeds_differ) {
    text += s.servo_tolerance > 0 ? "seeds had no effect on the scene: only the servos differ\n"
                                  : "seeds had no effect: all runs of a level are the same, and count as one\n";
  }
  if (!s.of_first.sensors.empty()) {
    text += fmt::format("for what reads inertial sensors (seed {}): {}\n", s.seed, s.of_first.sensors);
  }
  return text;
}

std::string summary(const Comparison& c, const Recommendation& r) {
  MUROSIMF_ASSERT(r.verdicts.size() == c.entries.size());
  std::string text = fmt::format("{}: {}\n", c.scene, r.verdict);
  for (std::size_t i = 0; i < c.entries.size(); ++i) {
    if (i != c.reference) text += line_of(c, c.entries[i], r.verdicts[i], width_of(c));
  }
  text += compared(c, fmt::format("seed {}", c.seed));
  if (!r.sensors.empty()) text += fmt::format("for what reads inertial sensors: {}\n", r.sensors);
  return text;
}

}  // namespace murosimf::studies
