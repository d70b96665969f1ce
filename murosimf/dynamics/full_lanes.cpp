#include "murosimf/dynamics/full_lanes.h"

#include "murosimf/math/assert.h"
#include "murosimf/multibody/inverse_dynamics.h"

namespace murosimf::dynamics {

FullLanes::FullLanes(std::vector<FullDynamics*> members)
    : members_(std::move(members)),
      trees_(parts_of(members_, [](FullDynamics& member) { return &member.tree_; })),
      joint_acceleration_(trees_.links.size()),
      joint_torque_(trees_.links.size()),
      joint_motion_(trees_.links.size()),
      link_force_(trees_.links.size()) {
  MUROSIMF_ASSERT(!members_.empty() && members_.size() <= Pack8::lanes);
}

void FullLanes::step(LaneMask due, const Instant& instant) noexcept {
  MUROSIMF_ASSERT(due >> members_.size() == 0 && instant.period > Duration{});
  const LaneMask lanes = trees_.ready(due);
  for_lanes(due & ~lanes, [&](int lane) { member(lane).step(of_lane(lane, instant)); });
  if (lanes == 0) return;
  dt_ = seconds(instant.period);
  begin(lanes);
  settle(lanes);
  end(lanes, instant);
}

void FullLanes::begin(LaneMask lanes) noexcept {
  trees_.take(lanes);
  for_lanes(lanes, [&](int lane) {
    FullDynamics& robot = member(lane);
    robot.dt_ = dt_;
    robot.joints_sane_ = robot.advance_joints(dt_);
    for (std::size_t l = 0; l < joint_acceleration_.size(); ++l) {
      joint_acceleration_[l].set_lane(lane, robot.joint_acceleration_[l]);
    }
  });
  trees_.look_for_loads(lanes);
  trees_.poses.take_joints(lanes);
  bias_ = multibody::base_bias<Pack8>(trees_.poses.structure, trees_.links, joint_acceleration_, joint_motion_);
}

/// ContactTrials::settle, in all lanes at once.
void FullLanes::settle(LaneMask lanes) noexcept {
  LaneMask open = lanes;
  for (int passes_left = collision::max_passes - 1;; --passes_left) {
    MUROSIMF_ASSERT(passes_left >= 0);
    // lanes that have settled keep their base: later passes only serve the others
    assign_where(where(open), solve_bases(open), base_);
    for_lanes(open, [&](int lane) {
      const auto acceleration_of = [&](int link) {
        return lane_of(base_, lane) + lane_of(joint_motion_[static_cast<std::size_t>(link)], lane);
      };
      trees_.predict_contacts(lane, dt_, acceleration_of);
      if (passes_left > 0 && member(lane).tree_.contacts.accept()) open &= ~lane_bit(lane);
    });
    MUROSIMF_ASSERT((open & ~lanes) == 0);
    if (passes_left == 0 || open == 0) return;
  }
}

/// FullDynamics::solve_base.
Twist<Pack8> FullLanes::solve_bases(LaneMask lanes) noexcept {
  Sym6<Pack8> inertia = to_sym6(trees_.whole);
  Wrench<Pack8> force = -1.0 * bias_;
  // a lane without this load keeps its sums bit for bit: adding a zero could change the sign of a zero
  trees_.for_loads(lanes, dt_, [&](std::size_t link, LaneMask loaded, const auto& load, const auto& damping) {
    Sym6<Pack8> more = inertia;
    Wrench<Pack8> left = force;
    more += damping;
    left += load - damping * joint_motion_[link];
    assign_where(where(loaded), more, inertia);
    assign_where(where(loaded), left, force);
  });
  return solve(inertia, force);
}

void FullLanes::end(LaneMask lanes, const Instant& instant) noexcept {
  LaneMask together = lanes;
  for_lanes(lanes, [&](int lane) {
    if (member(lane).joints_sane_) return;
    together &= ~lane_bit(lane);
    member(lane).tree_.halt(joints_insane);
  });
  // before the bases move: torques belong to the poses at the beginning of the step
  find_torques(together);
  for_lanes(together, [&](int lane) {
    member(lane).watch_torques(of_lane(lane, instant));
    member(lane).tree_.contacts.commit();
  });
  const LaneMask moved = trees_.advance_bases(base_, dt_, together);
  MUROSIMF_ASSERT((moved & ~together) == 0);
  for_lanes(together & ~moved, [&](int lane) { member(lane).tree_.halt(too_fast); });
  trees_.finish_step(moved);
}

/// FullDynamics::find_torques.
void FullLanes::find_torques(LaneMask lanes) noexcept {
  PoseLanes& poses = trees_.poses;
  const auto& links = poses.structure.links;
  for (std::size_t l = 0; l < links.size(); ++l) {
    link_force_[l] = trees_.links[l].inertia * acceleration(l) + trees_.links[l].bias_force;
  }
  trees_.for_loads(lanes, dt_, [&](std::size_t link, LaneMask loaded, const auto& load, const auto& damping) {
    Wrench<Pack8> force = link_force_[link];
    force += damping * acceleration(link) - load;
    assign_where(where(loaded), force, link_force_[link]);
  });
  const FullDynamics& first = *members_.front();
  for (std::size_t l = links.size() - 1; l > 0; --l) {
    const auto i = static_cast<std::size_t>(links[l].object);
    joint_torque_[l] = dot(trees_.links[l].axis, link_force_[l]) + first.rotor_[l] * joint_acceleration_[l] -
                       first.passive_[l].torque_as<Pack8>(poses.q[i], poses.qd[i]);
    link_force_[static_cast<std::size_t>(links[l].parent)] += link_force_[l];
  }
  poses.put_back(
      poses.joints(), lanes, [&](std::size_t k) -> const Pack8& { return joint_torque_[k + 1]; },
      [&](int lane) { return member(lane).joint_torque_.data(); });
}

}  // namespace murosimf::dynamics
