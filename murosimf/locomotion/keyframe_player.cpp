#include "murosimf/locomotion/keyframe_player.h"

#include <algorithm>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/mirrored_motion.h"
#include "murosimf/math/assert.h"

namespace murosimf::locomotion {

KeyframePlayer::KeyframePlayer(Setup& setup, const KeyframeMotion& motion)
    : motion_(played_by(setup.model(), motion)),
      duration_(duration(motion_)),
      targets_(setup.model(), motion_),
      values_(motion_.start),
      time_(setup.write(properties::motion_time)[0]),
      target_(setup.write(properties::joint_target)) {}

void KeyframePlayer::play(const KeyframeMotion& motion) {
  MUROSIMF_ASSERT(motion.columns.size() == motion_.columns.size());
  motion_ = motion;
  duration_ = duration(motion);
}

void KeyframePlayer::initialize() {
  time_ = 0;
  write_targets();
}

void KeyframePlayer::step(const Instant& instant) noexcept {
  MUROSIMF_ASSERT(instant.period.count() > 0);
  time_ = std::min(time_ + seconds(instant.period), duration_);
  write_targets();
}

void KeyframePlayer::write_targets() noexcept {
  MUROSIMF_ASSERT(values_.size() == motion_.columns.size());
  sample(motion_, time_, values_);
  targets_.write(values_, target_);
}

}  // namespace murosimf::locomotion
