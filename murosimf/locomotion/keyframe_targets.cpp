#include "murosimf/locomotion/keyframe_targets.h"

#include <algorithm>

#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/keyframe_channel.h"
#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/math/assert.h"

namespace murosimf::locomotion {

KeyframeTargets::KeyframeTargets(const Model& model, const KeyframeMotion& motion) : rest_(rest_positions(model)) {
  for (std::size_t column = 0; column < motion.columns.size(); ++column) {
    for (const Channel& channel : motion.columns[column]) connect(model, channel, column);
  }
  for (const JointSink& sink : joint_sinks_) rest_[sink.object] = 0;
  if (foot_sinks_.empty()) return;
  legs_ = find_legs(model);
  stance_ = seeded_parameters(model);
}

void KeyframeTargets::connect(const Model& model, const Channel& channel, std::size_t column) {
  if (const auto foot = foot_axis(channel.name)) {
    foot_sinks_.push_back({column, channel.sign, foot->side, foot->axis});
  } else {
    joint_sinks_.push_back({column, channel.sign, joint_of_channel(model, channel.name)});
  }
}

void KeyframeTargets::write(std::span<const double> values, std::span<double> targets) const noexcept {
  std::ranges::copy(rest_, targets.begin());
  if (!foot_sinks_.empty()) place_feet(values, targets);
  for (const JointSink& sink : joint_sinks_) {
    MUROSIMF_ASSERT(sink.column < values.size() && static_cast<std::size_t>(sink.object) < targets.size());
    targets[sink.object] += sink.sign * values[sink.column];
  }
}

void KeyframeTargets::place_feet(std::span<const double> values, std::span<double> targets) const noexcept {
  std::array<FootPlace, 2> places{};
  for (const FootSink& sink : foot_sinks_) {
    MUROSIMF_ASSERT(sink.column < values.size() && sink.side < 2 && sink.axis < 4);
    places[sink.side][sink.axis] += sink.sign * values[sink.column];
  }
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
  }
  write_pose(legs_, pose, targets);
}

}  // namespace murosimf::locomotion
