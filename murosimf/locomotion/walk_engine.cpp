#include "murosimf/locomotion/walk_engine.h"

#include <algorithm>

#include "murosimf/locomotion/rest_positions.h"

namespace murosimf::locomotion {

WalkEngine::WalkEngine(Setup& setup, const Vec3d& command)
    : WalkEngine(setup, command, seeded_parameters(setup.model())) {}

WalkEngine::WalkEngine(Setup& setup, const Vec3d& command, const WalkParameters& parameters)
    : legs_(legs_of(setup.model())),
      parameters_(parameters),
      clock_(setup, command),
      rest_(rest_positions(setup.model())),
      arms_(setup.model(), legs_, parameters_),
      target_(setup.write(properties::joint_target)) {}

void WalkEngine::initialize() {
  std::ranges::copy(rest_, target_.begin());
  clock_.initialize();
  write_targets(home_pose(legs_));
}

void WalkEngine::step(const Instant& instant) noexcept {
  clock_.advance(seconds(instant.period), {parameters_.period, parameters_.slew, parameters_.fastest});
  write_targets(pose_among(legs_, target_));
}

/// Legs without a closed form begin their iteration at the targets of the previous cycle.
void WalkEngine::write_targets(const GaitPose& start) noexcept {
  write_pose(legs_, gait_pose(legs_, parameters_, clock_.phase(), clock_.amplitude(), clock_.velocity(), start),
             target_);
  arms_.write(clock_.phase(), clock_.amplitude(), clock_.velocity().x, target_);
}

}  // namespace murosimf::locomotion
