#include "murosimf/dynamics/walking_lanes.h"

#include <bit>

#include "murosimf/math/assert.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::dynamics {

WalkingLanes::WalkingLanes(std::vector<KinematicWalking*> members)
    : members_(std::move(members)),
      poses_(parts_of(members_, [](KinematicWalking& member) { return &member.columns_; })) {
  MUROSIMF_ASSERT(members_.size() <= Pack8::lanes);
}

void WalkingLanes::step(LaneMask due, const Instant& instant) noexcept {
  MUROSIMF_ASSERT(due >> members_.size() == 0 && instant.period > Duration{});
  if (std::popcount(due) < fewest_in_lanes) {
    return for_lanes(due, [&](int lane) { member(lane).step(of_lane(lane, instant)); });
  }
  LaneMask lanes = 0;
  // a robot whose numbers are not sane is frozen by begin_step and leaves the lanes
  for_lanes(due, [&](int lane) {
    if (member(lane).begin_step(seconds(instant.period))) lanes |= lane_bit(lane);
  });
  poses_.take_joints(lanes);
  pin(lanes);
  poses_.update_poses();
  poses_.put_back_poses(lanes);
  set_base_twists(lanes);
  poses_.update_velocities();
  poses_.put_back_velocities(lanes);
  for_lanes(lanes, [&](int lane) { member(lane).end_step(); });
}

/// Calls act(foot, lanes that stand on it) for each foot on which any of them stands.
template <class Act>
void WalkingLanes::for_standing_feet(LaneMask lanes, const Act& act) noexcept {
  const auto& feet = members_.front()->feet_;
  for (std::size_t foot = 0; foot < feet.size(); ++foot) {
    // each foot has its own path of joints: lanes that stand on the other foot compute numbers that are not used
    LaneMask standing = 0;
    for_lanes(lanes, [&](int lane) {
      if (member(lane).standing() == foot) standing |= lane_bit(lane);
    });
    if (standing != 0) act(feet[foot], standing);
  }
}

void WalkingLanes::pin(LaneMask lanes) noexcept {
  for_standing_feet(lanes, [&](const Foot& foot, LaneMask standing) {
    const auto sole = multibody::pose_in_base<Pack8>(poses_.structure, foot.path, foot.place, poses_.q);
    for_lanes(standing, [&](int lane) {
      member(lane).pin(lane_of(sole, lane));
      set_lane(poses_.r[0], lane, poses_.columns(lane).r[0]);
      set_lane(poses_.R[0], lane, poses_.columns(lane).R[0]);
    });
  });
}

void WalkingLanes::set_base_twists(LaneMask lanes) noexcept {
  for_standing_feet(lanes, [&](const Foot& foot, LaneMask standing) {
    const Vec3<Pack8>& at = poses_.r[static_cast<std::size_t>(foot.object)];
    const auto sole =
        multibody::twist_against_base<Pack8>(poses_.structure, foot.path, at, poses_.qd, poses_.r, poses_.R);
    for_lanes(standing, [&](int lane) {
      member(lane).set_base_twist(lane_of(sole, lane));
      set_lane(poses_.v[0], lane, poses_.columns(lane).v[0]);
      set_lane(poses_.w[0], lane, poses_.columns(lane).w[0]);
    });
  });
}

}  // namespace murosimf::dynamics
