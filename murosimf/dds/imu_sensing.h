/// imu_sensing.h - an inertial sensor as the vendor's software knows it: its gyroscope, its accelerometer, and the attitude that a filter makes of both.
///
/// Roll and pitch are those of locomotion/attitude_filter.h, which starts with what the sensor shows before its first sample (a robot that is put on the
/// ground sinks into it at first); yaw is the integral of psi' = (w_y sin(roll) + w_z cos(roll)) / cos(pitch), which drifts.
#pragma once

#include <string>

#include "murosimf/control_software/robot_port.h"
#include "murosimf/dds/motors.h"
#include "murosimf/locomotion/attitude_filter.h"

namespace murosimf::dds {

class ImuSensing {
 public:
  /// Throws SetupError: the robot has no sensor of this name.
  ImuSensing(const Setup& setup, control_software::RobotPort& port, const std::string& name);

  void restart();
  /// To be called once in each cycle.
  void follow();
  [[nodiscard]] const ImuState& imu() const { return imu_; }
  /// [1] unit vector upward in the sensor's axes.
  [[nodiscard]] const Vec3d& up() const { return attitude_.up; }

  template <class Archive>
  void state(Archive& archive) {
    archive(attitude_.up, attitude_.bias, yaw_, started_);
  }

 private:
  double period_, gravity_;  // [s], [m/s^2]
  const murosimf_signal *gyroscope_, *accelerometer_;
  ImuState imu_;
  // state
  locomotion::AttitudeFilter attitude_;
  double yaw_ = 0;        // [rad]
  bool started_ = false;  // the filter has had a sample
};

}  // namespace murosimf::dds
