#include "murosimf/locomotion/gait.h"

#include <algorithm>
#include <cmath>

#include "murosimf/locomotion/stride.h"
#include "murosimf/math/assert.h"

namespace murosimf::locomotion {

GaitPose home_pose(const std::array<Leg, 2>& legs) noexcept {
  GaitPose pose;
  for (std::size_t side = 0; side < 2; ++side) {
    MUROSIMF_ASSERT(legs[side].home.size() == legs[side].joints.size() && legs[side].home.size() <= most_hinges);
    std::ranges::copy(legs[side].home, pose.q[side].begin());
  }
  return pose;
}

GaitPose pose_among(const std::array<Leg, 2>& legs, std::span<const double> values) noexcept {
  GaitPose pose;
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& joints = legs[side].joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      MUROSIMF_ASSERT(static_cast<std::size_t>(joints[i]) < values.size());
      pose.q[side][i] = values[joints[i]];
    }
  }
  return pose;
}

void write_pose(const std::array<Leg, 2>& legs, const GaitPose& pose, std::span<double> values) noexcept {
  for (std::size_t side = 0; side < 2; ++side) {
    const auto& joints = legs[side].joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      MUROSIMF_ASSERT(static_cast<std::size_t>(joints[i]) < values.size());
      values[joints[i]] = pose.q[side][i];
    }
  }
}

GaitFeet gait_feet(const std::array<Leg, 2>& legs, const WalkParameters& p, double phase, double amplitude,
                   const Vec3d& velocity, double gain, double setback) noexcept {
  MUROSIMF_ASSERT(p.period > 0 && p.double_support >= 0);
  const double d = p.double_support * pi / 2;
  const double stance_time = p.period * (pi + 2 * d) / (2 * pi) * gain;
  // Sideways sway is common to both feet: it moves the pelvis over the standing one.
  const double sway = amplitude * p.sway * std::sin(phase + p.lead);
  GaitFeet feet;
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = legs[side];
    const double outward = side == 0 ? 1 : -1;
    const Stride s = stride(side == 0 ? phase - pi : phase, d);
    feet.ankle[side] = {s.xi * velocity.x * stance_time - p.setback - setback,
                        outward * p.half_width - leg.hip.y + s.xi * velocity.y * stance_time - sway,
                        -p.hip_height + leg.ankle_height + amplitude * p.lift * s.lift};
    const double splayed = 0.5 * outward * p.splay * std::abs(velocity.z);
    feet.sole[side] = rotation_z((s.xi * velocity.z + splayed) * stance_time);
    const double standing = side == 0 ? std::sin(phase) : -std::sin(phase);
    feet.roll[side] = standing > 0 ? outward * amplitude * p.hip_roll * standing : 0;
  }
  return feet;
}

GaitPose gait_pose(const std::array<Leg, 2>& legs, const WalkParameters& p, double phase, double amplitude,
                   const Vec3d& velocity, const GaitPose& start) noexcept {
  const GaitFeet feet = gait_feet(legs, p, phase, amplitude, velocity);
  const Mat3d level_to_pelvis = rotation_y(-p.pitch);
  GaitPose pose = start;
  pose.reachable = true;
  for (std::size_t side = 0; side < 2; ++side) {
    const Leg& leg = legs[side];
    MUROSIMF_ASSERT(leg.joints.size() <= most_hinges);
    const FootTarget target{.ankle = level_to_pelvis * feet.ankle[side],
                            .sole = level_to_pelvis * feet.sole[side],
                            .roll = feet.roll[side]};
    const bool reached = bend(leg, target, std::span(pose.q[side]).first(leg.joints.size()));
    pose.reachable = pose.reachable && reached;
  }
  return pose;
}

GaitPose gait_pose(const std::array<Leg, 2>& legs, const WalkParameters& p, double phase, double amplitude,
                   const Vec3d& velocity) noexcept {
  return gait_pose(legs, p, phase, amplitude, velocity, home_pose(legs));
}

}  // namespace murosimf::locomotion
