#include "murosimf/studies/named_outcome.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/studies/compare_outcome.h"
#include "murosimf/studies/compare_verdict.h"

namespace murosimf::studies {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string_view> quantities_of(const OutcomeOwner& owner) {
  std::vector<std::string_view> names{"way", "end"};
  if (!owner.is_robot) names.insert(names.end(), {"speed", "touched"});
  if (owner.can_fall || owner.is_robot) names.emplace_back("falls");
  for (const ComparedQuantity& quantity : quantities()) {
    if (owner.is_robot && !quantity.of_another) names.push_back(quantity.name);
  }
  return names;
}

/// "known: ball.way, end, speed, touched; robot.way, end, ..."
std::string known(const std::vector<OutcomeOwner>& owners) {
  std::vector<std::string> lists;
  for (const OutcomeOwner& owner : owners) {
    lists.push_back(fmt::format("{}.{}", owner.name, fmt::join(quantities_of(owner), ", ")));
  }
  return fmt::format("known: {}", fmt::join(lists, "; "));
}

double tolerance_of(const std::string& text, std::size_t begin, const std::string& where) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [parsed, error] = std::from_chars(text.data() + begin, end, value);
  if (error != std::errc{} || parsed != end || !(value >= 0 && std::isfinite(value))) {
    throw SetupError(where + ": the tolerance must be a number from 0");
  }
  return value;
}

const ComparedQuantity& quantity_named(std::string_view name) {
  const auto found = std::ranges::find(quantities(), name, &ComparedQuantity::name);
  MUROSIMF_ASSERT(found != quantities().end());
  return *found;
}

/// [share of what the reference has] that the thresholds allow.
double allowed(std::string_view name, const Thresholds& thresholds) {
  MUROSIMF_ASSERT(thresholds.values.size() == quantities().size());
  const auto index = static_cast<std::size_t>(&quantity_named(name) - quantities().data());
  return thresholds.values[index] / quantity_named(name).scale;
}

OutcomeOff measured(const NamedOutcome& outcome, double value, double tolerance, const char* unit, int decimals = 2) {
  OutcomeOff off;
  off.value = value;
  const auto number = [&](double v) { return fmt::format("{:.{}f} {}", v, decimals, unit); };
  if (!(value <= tolerance)) {  // NaN is not
    off.reason = fmt::format("{} {} off, more than {}", outcome.name(), number(value), number(tolerance));
  }
  off.closeness = fmt::format("{} within {}", outcome.name(), number(value));
  return off;
}

OutcomeOff said(const NamedOutcome& outcome, const std::string& difference) {
  OutcomeOff off;
  off.value = nan;
  if (!difference.empty()) off.reason = fmt::format("{}: {}", outcome.name(), difference);
  off.closeness = fmt::format("{} as the reference's", outcome.name());
  return off;
}

std::string different_touch(const OtherRecord& mine, const OtherRecord& reference, double tolerance) {
  if (mine.touched.has_value() != reference.touched.has_value()) {
    return mine.touched ? "touches it, the reference does not" : "does not touch it, the reference does";
  }
  // Both touch it, or none does.
  if (!mine.touched || std::abs(*mine.touched - *reference.touched) <= tolerance) return {};
  return fmt::format("touches it {:.2f} s off", std::abs(*mine.touched - *reference.touched));
}

OutcomeOff robot_off(const NamedOutcome& outcome, const CompareEntry& entry, const CompareEntry& reference,
                     const Thresholds& thresholds) {
  const Measures &a = entry.measures, &b = reference.measures;
  const auto tolerance = [&](double usual) { return outcome.tolerance.value_or(usual); };
  if (outcome.quantity == "falls")
    return said(outcome, difference(a.events, b.events, tolerance(thresholds.fall_time)));
  if (outcome.quantity == "end") {
    return measured(outcome, norm(a.end - b.end), tolerance(allowed("center_max", thresholds)), "m");
  }
  if (outcome.quantity == "way") {
    const double usual = allowed("path_length", thresholds) * std::max(b.path_length, shortest_way);
    return measured(outcome, std::abs(a.path_length - b.path_length), tolerance(usual), "m");
  }
  const ComparedQuantity& quantity = quantity_named(outcome.quantity);
  return measured(outcome, quantity.of(entry.deviations),
                  tolerance(quantity.scale * allowed(quantity.name, thresholds)), std::string(quantity.unit).c_str(),
                  quantity.decimals);
}

OutcomeOff other_off(const NamedOutcome& outcome, const OtherRecord& mine, const OtherRecord& theirs,
                     const Thresholds& thresholds) {
  const OtherMeasures a = measures_of(mine), b = measures_of(theirs);
  const double way = std::max(b.way, shortest_way), speed = std::max(b.peak_speed, slowest_speed);
  const auto tolerance = [&](double usual) { return outcome.tolerance.value_or(usual); };
  if (outcome.quantity == "falls") {
    return said(outcome, difference(postures_of(mine), postures_of(theirs), tolerance(thresholds.fall_time)));
  }
  if (outcome.quantity == "touched") {
    return said(outcome, different_touch(mine, theirs, tolerance(std::numeric_limits<double>::infinity())));
  }
  if (outcome.quantity == "way") {
    return measured(outcome, std::abs(a.way - b.way), tolerance(way * allowed("others_way", thresholds)), "m");
  }
  if (outcome.quantity == "end") {
    return measured(outcome, norm(a.end - b.end), tolerance(way * allowed("others_end", thresholds)), "m");
  }
  return measured(outcome, std::abs(a.peak_speed - b.peak_speed),
                  tolerance(speed * allowed("others_speed", thresholds)), "m/s");
}

}  // namespace

NamedOutcome named_outcome(const std::string& text, const std::vector<OutcomeOwner>& owners) {
  const std::string where = fmt::format("--outcome '{}'", text);
  const auto equals = text.find('='), dot = text.substr(0, equals).rfind('.');
  if (dot == std::string::npos) throw SetupError(fmt::format("{}: write NAME.QUANTITY; {}", where, known(owners)));
  NamedOutcome outcome;
  outcome.owner = text.substr(0, dot);
  outcome.quantity = text.substr(dot + 1, equals == std::string::npos ? equals : equals - dot - 1);
  const auto owner = std::ranges::find(owners, outcome.owner, &OutcomeOwner::name);
  if (owner == owners.end()) {
    throw SetupError(fmt::format("{}: nothing that moves is called '{}'; {}", where, outcome.owner, known(owners)));
  }
  if (std::ranges::count(quantities_of(*owner), outcome.quantity) == 0) {
    throw SetupError(fmt::format("{}: unknown quantity '{}'; {}", where, outcome.quantity, known(owners)));
  }
  outcome.of_robot = owner->is_robot;
  if (equals != std::string::npos) outcome.tolerance = tolerance_of(text, equals + 1, where);
  return outcome;
}

OutcomeOff outcome_off(const NamedOutcome& outcome, const CompareEntry& entry, const CompareEntry& reference,
                       const Thresholds& thresholds) {
  if (outcome.of_robot) return robot_off(outcome, entry, reference, thresholds);
  const auto of = [&](const CompareEntry& e) {
    return std::ranges::find(e.outcome.others, outcome.owner, &OtherRecord::name);
  };
  const auto mine = of(entry), theirs = of(reference);
  MUROSIMF_ASSERT(mine != entry.outcome.others.end() && theirs != reference.outcome.others.end());
  return other_off(outcome, *mine, *theirs, thresholds);
}

}  // namespace murosimf::studies
