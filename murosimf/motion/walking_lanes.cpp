#include "murosimf/motion/walking_lanes.h"

#include <bit>

namespace murosimf::motion {

WalkingLanes::WalkingLanes(std::vector<KinematicWalking*> members)
    : members_(std::move(members)),
      poses_(parts_of(members_, [](KinematicWalking& member) { return &member.columns_; })) {}

void WalkingLanes::step(LaneMask due, const Instant& instant) noexcept {
  if (std::popcount(due) < fewest_in_lanes) {
    return for_lanes(due, [&](int lane) { member(lane).step(instant); });
  }
  LaneMask lanes = 0;
  for_lanes(due, [&](int lane) {
    if (!member(lane).begin_step(seconds(instant.period))) return;
    lanes |= lane_bit(lane);
    set_lane(poses_.r[0], lane, poses_.columns(lane).r[0]);
    set_lane(poses_.R[0], lane, poses_.columns(lane).R[0]);
  });
  poses_.take_joints(lanes);
  poses_.update_poses();
  poses_.put_back_poses(lanes);
  for_lanes(lanes, [&](int lane) {
    member(lane).set_base_twist();
    set_lane(poses_.v[0], lane, poses_.columns(lane).v[0]);
    set_lane(poses_.w[0], lane, poses_.columns(lane).w[0]);
  });
  poses_.update_velocities();
  poses_.put_back_velocities(lanes);
  for_lanes(lanes, [&](int lane) { member(lane).end_step(); });
}

}  // namespace murosimf::motion
