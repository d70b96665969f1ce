#include "murosimf/control_software/joint_trajectory.h"

#include <algorithm>
#include <cstddef>

#include "murosimf/math/assert.h"

namespace murosimf::control_software {

double value_at(const JointTrajectory::Joint& joint, double time, Between between) noexcept {
  MUROSIMF_ASSERT(!joint.times.empty() && joint.times.size() == joint.values.size());
  // upper_bound with the tolerance: a time of the table, rounded down by a clock, still yields its own row
  const auto after = std::upper_bound(joint.times.begin(), joint.times.end(), time + same_time);
  if (after == joint.times.begin()) return joint.values.front();
  const auto next = static_cast<std::size_t>(after - joint.times.begin());
  const std::size_t last = next - 1;
  const double since = time - joint.times[last];
  if (next == joint.times.size() || between == Between::hold || since <= same_time) return joint.values[last];
  const double share = since / (joint.times[next] - joint.times[last]);
  return joint.values[last] + share * (joint.values[next] - joint.values[last]);
}

double loop_period(const JointTrajectory& trajectory, double begin) noexcept {
  const double length = trajectory.last - begin;
  if (length <= same_time) return 0;
  // exact comparison: a closed motion repeats its first row digit by digit
  const bool closed = std::ranges::all_of(trajectory.joints, [&](const JointTrajectory::Joint& joint) {
    return value_at(joint, begin, Between::line) == joint.values.back();
  });
  return closed ? length : length + trajectory.spacing.value_or(0);
}

}  // namespace murosimf::control_software
