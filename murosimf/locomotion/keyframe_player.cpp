#include "murosimf/locomotion/keyframe_player.h"

#include <algorithm>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/keyframe_channel.h"
#include "murosimf/locomotion/mirrored_motion.h"

namespace murosimf::locomotion {
KeyframePlayer::KeyframePlayer(Setup& setup, const KeyframeMotion& motion)
    : motion_(played_by(setup.model(), motion)),
      duration_(duration(motion)),
      values_(motion.start),
      time_(setup.write(properties::motion_time)[0]),
      target_(setup.write(properties::joint_target)) {
  for (std::size_t column = 0; column < motion_.columns.size(); ++column) {
    for (const Channel& channel : motion_.columns[column]) connect(setup.model(), channel, column);
  }
  if (foot_sinks_.empty()) return;
  legs_ = find_legs(setup.model());
  stance_ = seeded_parameters(setup.model());
}

void KeyframePlayer::connect(const Model& model, const Channel& channel, std::size_t column) {
  if (const auto foot = foot_axis(channel.name)) {
    foot_sinks_.push_back({column, channel.sign, foot->side, foot->axis});
  } else {
    joint_sinks_.push_back({column, channel.sign, joint_of_channel(model, channel.name)});
  }
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
  std::fill(target_.begin(), target_.end(), 0.0);
  if (!foot_sinks_.empty()) place_feet();
  for (const JointSink& sink : joint_sinks_) target_[sink.object] += sink.sign * values_[sink.column];
}

void KeyframePlayer::place_feet() noexcept {
  std::array<FootPlace, 2> places{};
  for (const FootSink& sink : foot_sinks_) places[sink.side][sink.axis] += sink.sign * values_[sink.column];
  const Mat3d level_to_pelvis = rotation_y(-stance_.pitch);
  GaitPose pose = home_pose(legs_);
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = legs_[side];
    const auto& [x, y, z, pitch] = places[side];
    const double outward = side == 0 ? 1 : -1;
    const Vec3d ankle{x - stance_.setback, outward * stance_.half_width - leg.hip.y + y,
                      z - stance_.hip_height + leg.ankle_height};
    const FootTarget target{.ankle = level_to_pelvis * ankle, .sole = level_to_pelvis * rotation_y(pitch)};
    bend(leg, target, std::span(pose.q[side]).first(leg.joints.size()));
    for (std::size_t i = 0; i < leg.joints.size(); ++i) target_[leg.joints[i]] = pose.q[side][i];
  }
}

}  // namespace murosimf::locomotion
