#include "murosimf/identification/bench_servo.h"

#include <cmath>

#include "murosimf/identification/parameter.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::identification {
namespace {

void check(const Servo& servo) {
  if (servo.law != "dc_motor" || servo.voltage <= 0) {
    throw SetupError("servo '" + servo.type + "' cannot be put on the bench: it needs law 'dc_motor' and a voltage");
  }
}

/// Rounds to six digits: a fit is never that exact.
double six_digits(double x) {
  if (x == 0) return 0;
  const double scale = std::pow(10.0, 5 - std::floor(std::log10(std::fabs(x))));
  return std::round(x * scale) / scale;
}

}  // namespace

double duty_per_gain(const Servo& servo) {
  if (servo.firmware_gain <= 0 || servo.position_gain <= 0 || servo.stall_torque <= 0) {
    throw SetupError("servo '" + servo.type +
                     "' does not say what its firmware's gain means: it needs position_gain and firmware_gain");
  }
  return servo.position_gain / (servo.stall_torque * servo.firmware_gain);
}

multibody::BenchServo bench_servo(const Servo& servo, double encoder_offset) {
  check(servo);
  const double k_t = servo.voltage / servo.no_load_speed;
  return {.torque_constant = k_t,
          .resistance = k_t * servo.voltage / servo.stall_torque,
          .rotor_inertia = servo.rotor_inertia,
          .duty_limit = servo.duty_limit,
          .current_limit = servo.torque_limit / k_t,
          .encoder_offset = encoder_offset,
          .friction = servo.friction};
}

Servo servo_of(const multibody::BenchServo& found, const Servo& base) {
  check(base);
  MUROSIMF_ASSERT(found.torque_constant > 0 && found.resistance > 0);
  Servo servo = base;
  const double k_t = found.torque_constant;
  servo.stall_torque = six_digits(k_t * base.voltage / found.resistance);
  servo.no_load_speed = six_digits(base.voltage / k_t);
  servo.position_gain = duty_per_gain(base) * base.firmware_gain * servo.stall_torque;
  // The current limit stays the same; the torque at it follows the torque constant.
  servo.torque_limit = base.torque_limit * base.no_load_speed / base.voltage * k_t;
  servo.rotor_inertia = six_digits(found.rotor_inertia);
  multibody::BenchServo rounded = found;
  for (const Parameter& parameter : parameters()) parameter.set(rounded, six_digits(parameter.get(rounded)));
  servo.friction = rounded.friction;
  return servo;
}

}  // namespace murosimf::identification
