/// robot_sensing.h - what a Booster's own sensors tell its programs: joints, IMU, odometer and how it lies.
#pragma once

#include <span>
#include <vector>

#include "murosimf/control_software/robot_port.h"
#include "murosimf/dds/booster/messages.h"
#include "murosimf/dds/booster/robot_modes.h"
#include "murosimf/dds/imu_sensing.h"
#include "murosimf/dds/joint_sensing.h"

namespace murosimf::dds::booster {

/// x, y [m] and heading [rad].
using PlanarPose = Vec3d;

class RobotSensing {
 public:
  /// `places` of the robot's joints among the port's. Throws SetupError: the robot has no sensor 'imu'.
  RobotSensing(const Setup& setup, control_software::RobotPort& port, std::vector<std::size_t> places);

  void restart();
  /// To be called once in each cycle.
  void follow();

  [[nodiscard]] const ImuState& imu() const { return imu_.imu(); }
  [[nodiscard]] std::span<const MotorState> motors() const { return joints_.motors(); }
  [[nodiscard]] Posture posture() const;
  [[nodiscard]] Odometer odometer() const;
  /// The odometer shows this from now on [m, m, rad].
  void set_odometer(const PlanarPose& shown);

  template <class Archive>
  void state(Archive& archive) {
    archive(imu_, joints_, origin_, shown_);
  }

 private:
  JointSensing joints_;
  ImuSensing imu_;
  const murosimf_signal *mode_, *odometry_;
  // state
  PlanarPose origin_, shown_;  // the odometer shows `shown_` where the robot's odometry is `origin_`
};

}  // namespace murosimf::dds::booster
