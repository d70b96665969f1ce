#include "murosimf/dynamics/rigid_lanes.h"

#include <bit>

#include "murosimf/math/assert.h"

namespace murosimf::dynamics {

RigidLanes::RigidLanes(std::vector<SimplifiedDynamics*> members)
    : members_(std::move(members)),
      poses_(parts_of(members_, [](SimplifiedDynamics& member) { return &member.columns_; })) {
  MUROSIMF_ASSERT(members_.size() <= Pack8::lanes);
}

void RigidLanes::step(LaneMask due, const Instant& instant) noexcept {
  MUROSIMF_ASSERT(due >> members_.size() == 0);
  if (std::popcount(due) < fewest_in_lanes) {
    return for_lanes(due, [&](int lane) { member(lane).step(of_lane(lane, instant)); });
  }
  LaneMask lanes = 0;
  for_lanes(due, [&](int lane) {
    SimplifiedDynamics& robot = member(lane);
    const auto course = robot.find_course(instant);
    // frozen robots leave the lanes
    if (!course.sane) return;
    lanes |= lane_bit(lane);
    robot.turn(course.body);
    set_lane(body_, lane, course.body);
    set_lane(angular_momentum_, lane, course.angular_momentum);
    set_lane(poses_.R[0], lane, robot.columns_.R[0]);
  });
  if (lanes != 0) follow_centers(lanes);
}

/// SimplifiedDynamics::follow_center.
void RigidLanes::follow_centers(LaneMask lanes) noexcept {
  // everything relative to a base at rest at the origin, as in follow_center
  poses_.r[0] = poses_.v[0] = poses_.w[0] = {};
  poses_.take_joints(lanes);
  poses_.update_poses();
  poses_.update_velocities();
  auto common = multibody::common_body<Pack8>(poses_.structure, poses_.r, poses_.R, poses_.v, poses_.w);
  const Vec3<Pack8> w = inverse(common.inertia) * angular_momentum_;
  for (const std::size_t i : poses_.moving()) {
    const Vec3<Pack8> arm = poses_.r[i] - common.center;
    poses_.r[i] = body_.position + arm;
    poses_.v[i] += body_.velocity - common.velocity + cross(w, arm);
    poses_.w[i] += w;
  }
  poses_.put_back_poses(lanes);
  poses_.put_back_velocities(lanes);
  for_lanes(lanes, [&](int lane) {
    SimplifiedDynamics& robot = member(lane);
    robot.store_common_body(
        {common.mass, lane_of(body_.position, lane), lane_of(body_.velocity, lane), lane_of(common.inertia, lane)});
    robot.columns_.remember_base();
  });
}

}  // namespace murosimf::dynamics
