/// joint_drive_lanes.h - the drives of up to eight copies of one robot, each in its own lane: the counterpart of joint_drives.h.
#pragma once

#include <vector>

#include "murosimf/dynamics/pose_lanes.h"
#include "murosimf/dynamics/servo/joint_drives.h"

namespace murosimf::dynamics {

class JointDriveLanes {
 public:
  /// `robots`: equal ones (JointDrives::are_alike); they outlive this object.
  explicit JointDriveLanes(std::vector<const JointDrives*> robots);

  /// To be called once per step, after JointDrives::take_targets of these lanes: reads targets, supply and tuning of their motors.
  void take_inputs(PoseLanes& poses, LaneMask lanes) noexcept;
  /// JointDrives::drive, for the joint of a link: an object of the model.
  DriveOf<Pack8> drive(std::size_t link, int object, const Pack8& q, const Pack8& qd, double dt,
                       multibody::FrictionalJoint<Pack8>& joint) const noexcept;

 private:
  void take_tuning(PoseLanes& poses, LaneMask lanes) noexcept;

  std::vector<const JointDrives*> robots_;
  std::vector<Pack8> target_, supply_, enabled_;  // by link: [rad | m | rad/s], [V], [1]
  struct Tuning {
    Pack8 gain = 1.0, damping{}, limit{}, target_rate{}, feed_forward{};  // as of MotorInput
  };
  std::vector<Tuning> tuning_;  // by link; empty: software cannot set gains and limits
};

}  // namespace murosimf::dynamics
