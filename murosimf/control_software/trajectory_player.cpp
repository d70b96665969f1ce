#include "murosimf/control_software/trajectory_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

double begin_of(const JointTrajectory& trajectory, const TrajectoryOptions& options) {
  const double begin = options.begin.value_or(trajectory.first);
  if (begin >= trajectory.first && begin <= trajectory.last) return begin;
  throw SetupError(fmt::format("'begin' is {:.6g} s, but {} has the times {:.6g} to {:.6g} s", begin, options.file,
                               trajectory.first, trajectory.last));
}

}  // namespace

TrajectoryPlayer::TrajectoryPlayer(Setup& setup, JointTrajectory trajectory, const TrajectoryOptions& options)
    : trajectory_(std::move(trajectory)),
      between_(options.between == "hold" ? Between::hold : Between::line),
      begin_(begin_of(trajectory_, options)),
      delay_(options.delay),
      length_(trajectory_.last - begin_),
      period_(options.loop ? loop_period(trajectory_, begin_) : 0),
      time_(setup.write(properties::motion_time)[0]),
      target_(setup.write(properties::joint_target)) {
  MUROSIMF_ASSERT(length_ >= 0 && (period_ == 0 || period_ >= length_));
}

void TrajectoryPlayer::initialize() {
  time_ = -delay_;
  std::fill(target_.begin(), target_.end(), 0.0);
  write_targets();
}

void TrajectoryPlayer::step(const Instant& instant) noexcept {
  time_ += seconds(instant.period);
  if (period_ == 0) {
    time_ = std::min(time_, length_);
  } else if (time_ > period_ - same_time) {
    // floor of the shifted quotient: an instant within the tolerance of the end belongs to the next round
    time_ -= period_ * std::floor((time_ + same_time) / period_);
  }
  write_targets();
}

void TrajectoryPlayer::write_targets() noexcept {
  const double time = begin_ + std::max(0.0, time_);
  const double after_last = period_ > 0 ? time - trajectory_.last : 0;
  for (const JointTrajectory::Joint& joint : trajectory_.joints) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(joint.object) < target_.size());
    double value = value_at(joint, time, between_);
    if (after_last > same_time && between_ == Between::line) {  // on the way from the last row back to the first
      value += after_last / (period_ - length_) * (value_at(joint, begin_, between_) - value);
    }
    target_[joint.object] = value;
  }
}

double own_rate(const JointTrajectory& trajectory) noexcept {
  constexpr double otherwise = 100;
  MUROSIMF_ASSERT(!trajectory.spacing || *trajectory.spacing > 0);
  if (!trajectory.spacing) return otherwise;
  const double rate = 1 / *trajectory.spacing, whole = std::round(rate);
  const double near = whole > 0 && std::abs(rate - whole) < 1e-3 * whole ? whole : rate;
  return std::clamp(near, slowest_rate, usual_step_rate);
}

}  // namespace murosimf::control_software
