/// joint_sensing.h - what a robot's servos tell its vendor's software, in the order of the vendor.
#pragma once

#include <span>
#include <vector>

#include "murosimf/control_software/robot_port.h"
#include "murosimf/dds/motors.h"

namespace murosimf::dds {

class JointSensing {
 public:
  /// `places` of the robot's joints among the port's. `period` [s] of cycles. Throws SetupError.
  JointSensing(double period, control_software::RobotPort& port, std::vector<std::size_t> places);

  void restart();
  /// To be called once in each cycle.
  void follow();
  [[nodiscard]] std::span<const MotorState> motors() const { return motors_; }

  template <class Archive>
  void state(Archive& archive) {
    archive(rates_);
  }

 private:
  double period_;  // [s]
  std::vector<std::size_t> places_;
  const murosimf_signal *position_, *velocity_, *torque_;
  std::vector<MotorState> motors_;
  // state
  std::vector<double> rates_;  // [rad/s] in the cycle before, by joint
};

}  // namespace murosimf::dds
