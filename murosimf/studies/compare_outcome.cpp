#include "murosimf/studies/compare_outcome.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/studies/posture_events.h"

namespace murosimf::studies {
namespace {

constexpr std::size_t samples_around = 5;  // a touch: 50 ms

void keep_largest(double value, const std::string& name, OfAnother& worst) {
  if (value > worst.value) worst = {value, name};
}

/// Until when [s] it shows what both robots have done before one of them fell.
double judged_until(const OtherRecord& mine, const OtherRecord& reference, double fall) {
  const auto untouched_since = [&](const OtherRecord& other) { return other.touched_last.value_or(0) <= fall; };
  const bool touched = mine.touched || reference.touched;
  const bool to_its_end = touched && untouched_since(mine) && untouched_since(reference);
  return to_its_end ? std::numeric_limits<double>::infinity() : fall;
}

}  // namespace

std::vector<PostureEvent> postures_of(const OtherRecord& record) {
  Posture posture;
  for (const OtherSample& sample : record.samples) posture.see(sample.time, sample.cos_lean);
  return posture.events();
}

OtherMeasures measures_of(const OtherRecord& record) {
  return measures_of(record, std::numeric_limits<double>::infinity());
}

OtherMeasures measures_of(const OtherRecord& record, double until) {
  OtherMeasures m;
  Posture posture;
  std::vector<Vec3d> places;
  for (const OtherSample& sample : record.samples) {
    if (sample.time > until) break;
    places.push_back(sample.place);
    posture.see(sample.time, sample.cos_lean);
    m.peak_speed = std::max(m.peak_speed, sample.speed);
    m.end = sample.place;
  }
  m.way = length_of_way(places, record.can_fall ? swaying : 0);
  if (record.can_fall) m.falls = falls_in(posture.events());
  return m;
}

void compare_outcome(const OutcomeRecord& mine, const OutcomeRecord& reference, double fall, Deviations& deviations) {
  MUROSIMF_ASSERT(mine.others.size() == reference.others.size());
  for (std::size_t i = 0; i < mine.others.size(); ++i) {
    const OtherRecord &ours = mine.others[i], &theirs = reference.others[i];
    if (ours.samples.empty() || theirs.samples.empty()) continue;
    const double until = judged_until(ours, theirs, fall);
    const OtherMeasures a = measures_of(ours, until), b = measures_of(theirs, until);
    const double way = std::max(b.way, shortest_way), speed = std::max(b.peak_speed, slowest_speed);
    keep_largest(std::abs(a.way - b.way) / way, ours.name, deviations.others_way);
    keep_largest(norm(a.end - b.end) / way, ours.name, deviations.others_end);
    keep_largest(std::abs(a.peak_speed - b.peak_speed) / speed, ours.name, deviations.others_speed);
  }
}

std::vector<std::string> different_touches(const OutcomeRecord& mine, const OutcomeRecord& reference) {
  std::vector<std::string> differences;
  MUROSIMF_ASSERT(mine.others.size() == reference.others.size());
  for (std::size_t i = 0; i < mine.others.size(); ++i) {
    const OtherRecord &ours = mine.others[i], &theirs = reference.others[i];
    if (ours.touched.has_value() == theirs.touched.has_value()) continue;
    differences.push_back(ours.touched ? fmt::format("touches {}, the reference does not", ours.name)
                                       : fmt::format("does not touch {}, the reference does", ours.name));
  }
  return differences;
}

std::vector<std::string> different_falls_of_others(const OutcomeRecord& mine, const OutcomeRecord& reference,
                                                   double tolerance) {
  std::vector<std::string> differences;
  MUROSIMF_ASSERT(mine.others.size() == reference.others.size());
  for (std::size_t i = 0; i < mine.others.size(); ++i) {
    if (!mine.others[i].can_fall) continue;
    const auto line = difference(postures_of(mine.others[i]), postures_of(reference.others[i]), tolerance);
    if (!line.empty()) differences.push_back(fmt::format("{}: {}", mine.others[i].name, line));
  }
  return differences;
}

double duty_while_touching(const dynamics::MotionRecord& robot, const OutcomeRecord& outcome) {
  const std::size_t count = std::min(robot.samples.size(), outcome.touching.size());
  std::size_t near = 0, full = 0;
  for (std::size_t i = 0; i < count; ++i) {
    // Samples shortly before and after a touch count as part of it: servos load up around the impact.
    const std::size_t first = i > samples_around ? i - samples_around : 0;
    const std::size_t end = std::min(count, i + samples_around + 1);
    const auto begin = outcome.touching.begin();
    const bool touches = std::find(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
                                   true) != begin + static_cast<std::ptrdiff_t>(end);
    near += touches ? 1 : 0;
    full += touches && robot.samples[i].full_duty ? 1 : 0;
  }
  return near == 0 ? 0 : static_cast<double>(full) / static_cast<double>(near);
}

std::vector<std::string> touched(const OutcomeRecord& outcome) {
  std::vector<std::string> names;
  for (const OtherRecord& other : outcome.others) {
    if (other.touched) names.push_back(other.name);
  }
  return names;
}

}  // namespace murosimf::studies
