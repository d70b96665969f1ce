#include "murosimf/multibody/servo/servo_motor.h"

#include <limits>

namespace murosimf::multibody {

ServoMotor::ServoMotor(const Servo& servo)
    : gain(servo.position_gain),
      line(servo.stall_torque / servo.no_load_speed),
      most(servo.duty_limit * servo.stall_torque),
      torque_limit(servo.torque_limit > 0 ? servo.torque_limit : std::numeric_limits<double>::infinity()),
      warm_limit(servo.torque_limit > 0 ? servo.torque_limit : servo.stall_torque),
      encoder_step(servo.encoder_step),
      dead_band(servo.dead_band),
      torque_constant(servo.voltage / servo.no_load_speed),
      resistance(torque_constant * servo.voltage / servo.stall_torque),
      heat(servo.heat) {}

}  // namespace murosimf::multibody
