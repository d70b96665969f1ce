/// motors.h - what servos and inertial sensors of a robot tell its vendor's software, and what servos are told.
///
/// Positions [rad], rates [rad/s], torques [N m], gains [N m/rad] and [N m s/rad].
#pragma once

#include <array>
#include <cstdint>

namespace murosimf::dds {

struct ImuState {
  std::array<float, 3> rpy{};   ///< [rad] roll, pitch, yaw
  std::array<float, 3> gyro{};  ///< [rad/s]
  std::array<float, 3> acc{};   ///< [m/s^2] specific force: +9.81 upward at rest
};

struct MotorState {
  float q = 0, dq = 0, ddq = 0, tau = 0;
  std::uint8_t temperature = 0;  ///< [C]
};

/// Floats and nothing else, so that it can be saved.
struct MotorCommand {
  float q = 0, dq = 0, tau = 0, kp = 0, kd = 0;
  float weight = 0;  ///< [1] 1: this command alone
};

}  // namespace murosimf::dds
