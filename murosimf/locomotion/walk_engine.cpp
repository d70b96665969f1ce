#include "murosimf/locomotion/walk_engine.h"

#include <algorithm>

namespace murosimf::locomotion {

WalkEngine::WalkEngine(Setup& setup, const Vec3d& command)
    : WalkEngine(setup, command, seeded_parameters(setup.model())) {}

WalkEngine::WalkEngine(Setup& setup, const Vec3d& command, const WalkParameters& parameters)
    : legs_(legs_of(setup.model())),
      parameters_(parameters),
      clock_(setup, command),
      target_(setup.write(properties::joint_target)) {}

void WalkEngine::initialize() {
  std::fill(target_.begin(), target_.end(), 0.0);
  clock_.initialize();
  write_targets(home_pose(legs_));
}

void WalkEngine::step(const Instant& instant) noexcept {
  clock_.advance(seconds(instant.period), {parameters_.period, parameters_.slew, parameters_.fastest});
  write_targets(last_pose());
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
  const GaitPose pose = gait_pose(legs_, parameters_, clock_.phase(), clock_.amplitude(), clock_.velocity(), start);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& joints = legs_[side].joints;
    for (std::size_t i = 0; i < joints.size(); ++i) target_[joints[i]] = pose.q[side][i];
  }
}

}  // namespace murosimf::locomotion
