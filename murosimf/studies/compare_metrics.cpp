#include "murosimf/studies/compare_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/math/assert.h"

namespace murosimf::studies {
namespace {

using dynamics::MotionRecord;
using dynamics::MotionSample;

const double cos_unstable = std::cos(pi / 12);

double horizontal(const Vec3d& v) { return std::hypot(v.x, v.y); }

double cos_lean(const MotionSample& sample) { return std::cos(sample.pitch) * std::cos(sample.roll); }

double path_length(const std::vector<MotionSample>& samples) {
  std::vector<Vec3d> places;
  for (const MotionSample& sample : samples) places.push_back(sample.base);
  return length_of_way(places, swaying);
}

std::vector<PostureEvent> events_of(const std::vector<MotionSample>& samples) {
  Posture posture;
  for (const MotionSample& sample : samples) posture.see(sample.time, cos_lean(sample));
  return posture.events();
}

double highest(const MotionRecord& record, std::size_t foot) {
  MUROSIMF_ASSERT(foot < record.soles);
  double result = 0;
  for (const MotionSample& sample : record.samples) result = std::max(result, sample.clearance[foot]);
  return result;
}

/// From a point to a piece of path, in the ground plane.
double distance(const Vec3d& point, const Vec3d& a, const Vec3d& b) {
  const Vec3d along{b.x - a.x, b.y - a.y, 0}, to{point.x - a.x, point.y - a.y, 0};
  const double squared = dot(along, along);
  const double share = squared > 0 ? std::clamp(dot(to, along) / squared, 0.0, 1.0) : 0;
  return norm(to - share * along);
}

double distance(const Vec3d& point, const std::vector<MotionSample>& path) {
  double nearest = std::numeric_limits<double>::infinity();
  // To the pieces between samples, not only to the samples: both robots pass a place at different times.
  for (std::size_t i = 1; i < path.size(); ++i) {
    nearest = std::min(nearest, distance(point, path[i - 1].base, path[i].base));
  }
  return path.size() == 1 ? horizontal(point - path[0].base) : nearest;
}

/// Samples are a hundredth of a second apart; a tenth is enough for a distance from a path.
double largest_distance(const std::vector<MotionSample>& samples, const std::vector<MotionSample>& path) {
  double largest = 0;
  for (std::size_t i = 0; i < samples.size(); i += 10) largest = std::max(largest, distance(samples[i].base, path));
  return samples.empty() ? largest : std::max(largest, distance(samples.back().base, path));
}

/// [m/s]
double slip_rate(const MotionRecord& record) {
  if (record.samples.size() < 2) return 0;
  return record.samples.back().slip / (record.samples.back().time - record.samples.front().time);
}

double share(double value, double reference, double least) {
  return std::abs(value - reference) / std::max(std::abs(reference), least);
}

/// What is compared sample by sample.
void compare_in_time(Deviations& d, const std::vector<MotionSample>& ours, const std::vector<MotionSample>& theirs) {
  const std::size_t count = std::min(ours.size(), theirs.size());
  double pitches = 0, rolls = 0, rates = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const MotionSample &a = ours[i], &b = theirs[i];
    const double center = norm(a.center - b.center), pitch = std::remainder(a.pitch - b.pitch, 2 * pi);
    d.center_mean += center / static_cast<double>(count);
    d.center_max = std::max(d.center_max, center);
    pitches += pitch * pitch;
    rolls += (a.roll - b.roll) * (a.roll - b.roll);
    rates += dot(a.rate - b.rate, a.rate - b.rate);
  }
  // Without samples all sums are 0.
  const double samples = std::max(1.0, static_cast<double>(count));
  d.pitch = std::sqrt(pitches / samples);
  d.roll = std::sqrt(rolls / samples);
  d.rate = std::sqrt(rates / samples);
}

}  // namespace

double length_of_way(const std::vector<Vec3d>& places, double apart) {
  if (places.empty()) return 0;
  double length = 0;
  Vec3d last = places.front();
  for (const Vec3d& place : places) {
    const double step = horizontal(place - last);
    // Swaying does not add up: a place counts when it is `apart` from the last one that counted.
    if (step < apart) continue;
    length += step;
    last = place;
  }
  return length + horizontal(places.back() - last);
}

double fall_begins(const MotionRecord& record) {
  const auto events = events_of(record.samples);
  const double fall = first_fall(events);
  if (std::isinf(fall)) return fall;
  double begin = events.front().time;  // one that gets up by half and falls again was never stable
  for (const MotionSample& sample : record.samples) {
    if (sample.time < fall && cos_lean(sample) >= cos_unstable) begin = sample.time;
  }
  return begin;
}

MotionRecord part_until(const MotionRecord& record, double end) {
  MotionRecord part = record;
  std::erase_if(part.samples, [&](const MotionSample& sample) { return sample.time > end; });
  // Rows of all joints, one for each sample.
  part.torques.resize(part.samples.size() * part.joints.size());
  return part;
}

Measures measures_of(const MotionRecord& record) {
  Measures m;
  if (record.samples.empty()) return m;
  m.path_length = path_length(record.samples);
  m.end = record.samples.back().base;
  m.slip = record.samples.back().slip;
  m.events = events_of(record.samples);
  for (const MotionSample& sample : record.samples) m.rate += dot(sample.rate, sample.rate);
  m.rate = std::sqrt(m.rate / static_cast<double>(record.samples.size()));
  m.falls = falls_in(m.events);
  for (std::size_t foot = 0; foot < record.soles; ++foot) m.clearance = std::max(m.clearance, highest(record, foot));
  MUROSIMF_ASSERT(record.torques.empty() || !record.joints.empty());
  for (std::size_t i = 0; i < record.torques.size(); ++i) {
    const double torque = std::abs(record.torques[i]);
    // A torque of 0 names its joint, too: no name means that the level has no torques.
    if (!m.peak_joint.empty() && torque <= m.peak_torque) continue;
    m.peak_torque = torque;
    m.peak_joint = record.joints[i % record.joints.size()];
  }
  return m;
}

/// NaN where a level has no torques: 0 would mean that they agree.
Deviations deviations_of(const MotionRecord& record, const MotionRecord& reference) {
  Deviations d;
  const Measures mine = measures_of(record), other = measures_of(reference);
  d.path_length = share(mine.path_length, other.path_length, shortest_way);
  d.path = largest_distance(record.samples, reference.samples);
  d.slip = std::abs(slip_rate(record) - slip_rate(reference));
  d.clearance = std::abs(mine.clearance - other.clearance);
  const bool torques = !mine.peak_joint.empty() && !other.peak_joint.empty();
  d.torque = torques ? share(mine.peak_torque, other.peak_torque, 1e-9) : std::numeric_limits<double>::quiet_NaN();
  compare_in_time(d, record.samples, reference.samples);
  return d;
}

}  // namespace murosimf::studies
