#include "murosimf/locomotion/keyframe_player.h"

#include <algorithm>
#include <cassert>

#include "murosimf/locomotion/gait_properties.h"

namespace murosimf::locomotion {

KeyframePlayer::KeyframePlayer(Setup& setup, const KeyframeMotion& motion)
    : motion_(motion),
      duration_(duration(motion)),
      targets_(setup.model(), motion),
      values_(motion.start),
      time_(setup.write(properties::motion_time)[0]),
      target_(setup.write(properties::joint_target)) {}

void KeyframePlayer::play(const KeyframeMotion& motion) {
  assert(motion.columns.size() == motion_.columns.size());
  motion_ = motion;
  duration_ = duration(motion);
}

void KeyframePlayer::initialize() {
  time_ = 0;
  write_targets();
}

void KeyframePlayer::step(const Instant& instant) noexcept {
  time_ = std::min(time_ + seconds(instant.period), duration_);
  write_targets();
}

void KeyframePlayer::write_targets() noexcept {
  sample(motion_, time_, values_);
  targets_.write(values_, target_);
}

}  // namespace murosimf::locomotion
