/// bench_servo.h - servos of robots as servos on the bench, and back.
#pragma once

#include "murosimf/model/servo.h"
#include "murosimf/multibody/servo/servo_pendulum.h"

namespace murosimf::identification {

/// Duty cycle per firmware gain and angle of error [1/rad]. Throws SetupError if the servo does not say to which
/// firmware gain its position gain belongs.
[[nodiscard]] double duty_per_gain(const Servo& servo);

/// k_t = voltage / no_load_speed, R = k_t voltage / stall_torque, current limit = torque_limit / k_t. Throws SetupError
/// if the servo is no dc_motor of known voltage.
[[nodiscard]] multibody::BenchServo bench_servo(const Servo& servo, double encoder_offset);

/// `base` with motor and friction of `found`, at the voltage and firmware gain of `base`; numbers have six digits. A
/// current limit stays. Throws SetupError as above.
[[nodiscard]] Servo servo_of(const multibody::BenchServo& found, const Servo& base);

}  // namespace murosimf::identification
