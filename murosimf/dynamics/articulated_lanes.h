/// articulated_lanes.h - up to eight copies of one robot at level `articulated_dynamics`, stepped together in lanes.
///
/// The step of articulated_dynamics.h with packs in the place of numbers. Parts with robot-specific branches are executed lane by lane:
/// contacts and their law, targets under way. A robot whose contacts agree keeps the outcome of its pass while others repeat theirs.
/// A robot whose step an island solver has settled is advanced alone; its poses and links are nevertheless computed in lanes.
#pragma once

#include <span>
#include <vector>

#include "murosimf/dynamics/articulated_dynamics.h"
#include "murosimf/dynamics/servo/joint_drive_lanes.h"
#include "murosimf/dynamics/tree_lanes.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/lane_group.h"

namespace murosimf::dynamics {

class ArticulatedLanes final : public LaneGroup {
 public:
  explicit ArticulatedLanes(std::vector<ArticulatedDynamics*> members);
  void step(LaneMask due, const Instant& instant) noexcept override;

 private:
  /// The results of a pass for a link and its joint's friction that the end of the step reads.
  template <class S>
  struct Outcome {
    Twist<S> acceleration;
    S joint_acceleration, load, drive, budget, direction;
    multibody::TorqueLine<S> line;
  };

  [[nodiscard]] ArticulatedDynamics& member(int lane) const noexcept {
    MUROSIMF_ASSERT(lane >= 0 && static_cast<std::size_t>(lane) < members_.size());
    return *members_[static_cast<std::size_t>(lane)];
  }
  void begin(LaneMask lanes) noexcept;
  void recall_loads(LaneMask lanes) noexcept;
  void drive_joints() noexcept;
  void settle(LaneMask lanes) noexcept;
  void gather_loads(LaneMask lanes) noexcept;
  void add_load(std::size_t link, LaneMask lanes, const Wrench<Pack8>& force, const Sym6<Pack8>& damping) noexcept;
  [[nodiscard]] Pack8 pass(multibody::Loads loads) noexcept;
  void predict_contacts(int lane) noexcept;
  void keep_outcomes() noexcept;
  void recall_outcomes(LaneMask open) noexcept;
  [[nodiscard]] LaneMask end(LaneMask lanes) noexcept;
  [[nodiscard]] LaneMask advance_alone(LaneMask lanes) noexcept;
  [[nodiscard]] LaneMask lanes_of_sane_rates() const noexcept;
  void report_torques(LaneMask lanes) noexcept;
  void watch_saturation(LaneMask lanes) noexcept;
  void keep_loads(LaneMask lanes) noexcept;
  void advance_joints(LaneMask lanes) noexcept;

  std::vector<ArticulatedDynamics*> members_;
  TreeLanes trees_;
  JointDriveLanes motors_;
  std::vector<bool> leaf_;                                   // by link: it has no child
  std::vector<DriveOf<Pack8>> viscous_;                      // by link: friction of the servo's gear
  std::vector<multibody::FrictionalJoint<Pack8>> friction_;  // by link
  std::vector<multibody::ArticulatedLink<Pack8>> bodies_;    // by link
  std::vector<Pack8> joint_torque_, motor_torque_;           // by link
  std::vector<Outcome<Pack8>> outcome_;                      // by link
  std::vector<LaneMask> loaded_;                             // by link: lanes that have a load in the present pass
  double dt_ = 0;                                            // [s] of the present step
};

}  // namespace murosimf::dynamics
