#include "murosimf/control/walk_engine.h"

#include <algorithm>
#include <cmath>

namespace murosimf::control {
namespace {

constexpr double ramp = 0.6;  // [periods] from standing to full sway and lift

double approach(double value, double goal, double step) { return value + std::clamp(goal - value, -step, step); }

Vec3d clipped(const Vec3d& v, const Vec3d& limit) {
  return {std::clamp(v.x, -limit.x, limit.x), std::clamp(v.y, -limit.y, limit.y), std::clamp(v.z, -limit.z, limit.z)};
}

}  // namespace

WalkEngine::WalkEngine(Setup& setup, const Vec3d& command)
    : WalkEngine(setup, command, seeded_parameters(find_legs(setup.model()))) {}

WalkEngine::WalkEngine(Setup& setup, const Vec3d& command, const WalkParameters& parameters)
    : legs_(find_legs(setup.model())),
      parameters_(parameters),
      command_(setup.input(properties::walk_command, command)[0]),
      velocity_(setup.write(properties::gait_velocity)[0]),
      phase_(setup.write(properties::gait_phase)[0]),
      amplitude_(setup.write(properties::gait_amplitude)[0]),
      target_(setup.write(properties::joint_target)) {}

void WalkEngine::initialize() {
  std::fill(target_.begin(), target_.end(), 0.0);
  velocity_ = {};
  phase_ = amplitude_ = 0;
  write_targets(home_pose(legs_));
}

void WalkEngine::step(const Instant& instant) noexcept {
  advance(seconds(instant.period));
  write_targets(last_pose());
}

void WalkEngine::advance(double dt) noexcept {
  const Vec3d goal = clipped(command_, parameters_.fastest);
  const Vec3d& slew = parameters_.slew;
  velocity_ = {approach(velocity_.x, goal.x, dt * slew.x), approach(velocity_.y, goal.y, dt * slew.y),
               approach(velocity_.z, goal.z, dt * slew.z)};
  const bool walking = !is_zero(goal) || !is_zero(velocity_);
  amplitude_ = approach(amplitude_, walking ? 1 : 0, dt / (ramp * parameters_.period));
  phase_ = amplitude_ > 0 ? std::fmod(phase_ + 2 * pi * dt / parameters_.period, 2 * pi) : 0.0;
}

/// As the targets are: what was looked for in the cycle before.
GaitPose WalkEngine::last_pose() const noexcept {
  GaitPose pose;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& joints = legs_[side].joints;
    for (std::size_t i = 0; i < joints.size(); ++i) pose.q[side][i] = target_[joints[i]];
  }
  return pose;
}

void WalkEngine::write_targets(const GaitPose& start) noexcept {
  const GaitPose pose = gait_pose(legs_, parameters_, phase_, amplitude_, velocity_, start);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& joints = legs_[side].joints;
    for (std::size_t i = 0; i < joints.size(); ++i) target_[joints[i]] = pose.q[side][i];
  }
}

}  // namespace murosimf::control
