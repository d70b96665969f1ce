/// low_level.h - commands of a robot's joints by its vendor's software: servos with their own gains, limp, or as a program says.
///
///     tau = kp (q_d - q) + kd (dq_d - dq) + tau_ff
///
/// within the limits of the servo (dynamics/servo/servo_law.h), where levels have servos; others follow q_d. A command's `weight` w from 0 to 1 blends
/// it with holding the joint, with the servo's own gains, where it was when the program took it over: each of q_d, kp, kd is
/// (1 - w) own + w given, and dq_d and tau_ff count w times. How real robots blend is not published: this is our own law.
#pragma once

#include <span>
#include <vector>

#include "murosimf/control_software/robot_port.h"
#include "murosimf/dds/motors.h"

namespace murosimf::dds {

class LowLevel {
 public:
  /// `places` of the robot's joints among the port's. Asks for its commands. Throws SetupError.
  LowLevel(control_software::RobotPort& port, std::vector<std::size_t> places);

  /// The motion engine moves a joint, by its number in the robot's order.
  void leave_to_motions(std::size_t joint);
  /// Its servo is off but for the damping of its own velocity gain; levels without servos hold it at `q` [rad].
  void damp(std::size_t joint, double q);
  /// Its servo holds it at `q` [rad].
  void hold(std::size_t joint, double q);
  void drive(std::size_t joint, const MotorCommand& command, double held);
  /// [rad] where its servo drives it at present.
  [[nodiscard]] double target(std::size_t joint) const { return target_->values[places_[joint]]; }

 private:
  struct Numbers {
    double q = 0, rate = 0, kp = 0, kd = 0, torque = 0;
  };
  struct Row {
    murosimf_command* command = nullptr;
    control_software::CommandRange range;
  };
  void set(std::size_t joint, const Numbers& numbers, bool by_engine);

  std::vector<std::size_t> places_;
  murosimf_command *engine_, *target_;
  Row targets_, rates_, position_gains_, velocity_gains_, torques_;
  std::vector<double> own_kp_, own_kd_;  // by joint
};

}  // namespace murosimf::dds
