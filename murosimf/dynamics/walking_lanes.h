/// walking_lanes.h - up to eight copies of one robot at level `kinematic_walking`, whose poses and velocities are worked out
/// together in lanes; those of the soles on which they stand first, as the bases follow from them.
#pragma once

#include <vector>

#include "murosimf/dynamics/kinematic_walking.h"
#include "murosimf/dynamics/pose_lanes.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/lane_group.h"

namespace murosimf::dynamics {

class WalkingLanes final : public LaneGroup {
 public:
  explicit WalkingLanes(std::vector<KinematicWalking*> members);
  void step(LaneMask due, const Instant& instant) noexcept override;

 private:
  using Foot = KinematicWalking::Foot;
  template <class Act>
  void for_standing_feet(LaneMask lanes, const Act& act) noexcept;
  void pin(LaneMask lanes) noexcept;
  void set_base_twists(LaneMask lanes) noexcept;
  [[nodiscard]] KinematicWalking& member(int lane) const noexcept {
    MUROSIMF_ASSERT(lane >= 0 && static_cast<std::size_t>(lane) < members_.size());
    return *members_[static_cast<std::size_t>(lane)];
  }

  std::vector<KinematicWalking*> members_;
  PoseLanes poses_;
};

}  // namespace murosimf::dynamics
