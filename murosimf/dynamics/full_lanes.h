/// full_lanes.h - up to eight copies of one robot at level `full_dynamics`, stepped together in lanes.
///
/// The step of full_dynamics.h with packs in the place of numbers. The joints' references, contacts and their law are executed lane by lane.
#pragma once

#include <vector>

#include "murosimf/dynamics/full_dynamics.h"
#include "murosimf/dynamics/tree_lanes.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/lane_group.h"

namespace murosimf::dynamics {

class FullLanes final : public LaneGroup {
 public:
  explicit FullLanes(std::vector<FullDynamics*> members);
  void step(LaneMask due, const Instant& instant) noexcept override;

 private:
  [[nodiscard]] FullDynamics& member(int lane) const noexcept {
    MUROSIMF_ASSERT(lane >= 0 && static_cast<std::size_t>(lane) < members_.size());
    return *members_[static_cast<std::size_t>(lane)];
  }
  [[nodiscard]] Twist<Pack8> acceleration(std::size_t link) const noexcept { return base_ + joint_motion_[link]; }
  void begin(LaneMask lanes) noexcept;
  void settle(LaneMask lanes) noexcept;
  [[nodiscard]] Twist<Pack8> solve_bases(LaneMask lanes) noexcept;
  void end(LaneMask lanes, const Instant& instant) noexcept;
  void find_torques(LaneMask lanes) noexcept;

  std::vector<FullDynamics*> members_;
  TreeLanes trees_;
  std::vector<Pack8> joint_acceleration_, joint_torque_;  // by link, as in FullDynamics
  std::vector<Twist<Pack8>> joint_motion_;                // by link
  std::vector<Wrench<Pack8>> link_force_;                 // by link
  Wrench<Pack8> bias_;
  Twist<Pack8> base_;
  double dt_ = 0;  // [s] of the present step
};

}  // namespace murosimf::dynamics
