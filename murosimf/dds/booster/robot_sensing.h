/// robot_sensing.h - what a Booster's own sensors tell its programs: joints, IMU, odometer and how it lies.
#pragma once

#include <span>
#include <vector>

#include "murosimf/control_software/robot_port.h"
#include "murosimf/dds/booster/messages.h"
#include "murosimf/dds/booster/robot_modes.h"
#include "murosimf/locomotion/attitude_filter.h"

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

  [[nodiscard]] const ImuState& imu() const { return imu_; }
  [[nodiscard]] std::span<const MotorState> motors() const { return motors_; }
  [[nodiscard]] Posture posture() const;
  [[nodiscard]] Odometer odometer() const;
  /// The odometer shows this from now on [m, m, rad].
  void set_odometer(const PlanarPose& shown);

  template <class Archive>
  void state(Archive& archive) {
    archive(attitude_.up, attitude_.bias, yaw_, started_, rates_, origin_, shown_);
  }

 private:
  void follow_imu();

  double period_, gravity_;  // [s], [m/s^2]
  std::vector<std::size_t> places_;
  const murosimf_signal *position_, *velocity_, *torque_, *gyroscope_, *accelerometer_, *mode_, *odometry_;
  std::vector<MotorState> motors_;
  ImuState imu_;
  // state
  locomotion::AttitudeFilter attitude_;
  double yaw_ = 0;             // [rad]
  bool started_ = false;       // the filter has had a sample
  std::vector<double> rates_;  // [rad/s] in the cycle before, by joint
  PlanarPose origin_, shown_;  // the odometer shows `shown_` where the robot's odometry is `origin_`
};

}  // namespace murosimf::dds::booster
