/// rigid_lanes.h - up to eight copies of one robot at level `simplified_dynamics`, whose poses, velocities and common body are
/// computed together in lanes.
#pragma once

#include <vector>

#include "murosimf/dynamics/pose_lanes.h"
#include "murosimf/dynamics/simplified_dynamics.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/lane_group.h"

namespace murosimf::dynamics {

class RigidLanes final : public LaneGroup {
 public:
  /// `members`: robots whose center of mass is integrated, by the semi-implicit integrator.
  explicit RigidLanes(std::vector<SimplifiedDynamics*> members);
  void step(LaneMask due, const Instant& instant) noexcept override;

 private:
  [[nodiscard]] SimplifiedDynamics& member(int lane) const noexcept {
    MUROSIMF_ASSERT(lane >= 0 && static_cast<std::size_t>(lane) < members_.size());
    return *members_[static_cast<std::size_t>(lane)];
  }
  void follow_centers(LaneMask lanes) noexcept;

  std::vector<SimplifiedDynamics*> members_;
  PoseLanes poses_;
  multibody::FreeBody<Pack8> body_;
  Vec3<Pack8> angular_momentum_;  // [N m s] about the center of mass
};

}  // namespace murosimf::dynamics
