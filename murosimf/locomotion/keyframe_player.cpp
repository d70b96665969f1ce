#include "murosimf/locomotion/keyframe_player.h"

#include <algorithm>

#include "murosimf/locomotion/gait_properties.h"

namespace murosimf::locomotion {

KeyframePlayer::KeyframePlayer(Setup& setup, const KeyframeMotion& motion)
    : pose_(setup.model(), motion),
      time_(setup.write(properties::motion_time)[0]),
      target_(setup.write(properties::joint_target)) {}

void KeyframePlayer::initialize() {
  time_ = 0;
  pose_.write(time_, target_);
}

void KeyframePlayer::step(const Instant& instant) noexcept {
  time_ = std::min(time_ + seconds(instant.period), pose_.duration());
  pose_.write(time_, target_);
}

}  // namespace murosimf::locomotion
