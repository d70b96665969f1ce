/// fitted_servo.h - servo files written by a fit: an ordinary servo, and its origin in the table [fit].
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/model/servo.h"

namespace murosimf::identification {

/// One log and the error of the servo's simulation of it.
struct LogError {
  std::string log, trajectory;
  double firmware_gain = 0;
  double error = 0;  ///< [rad] mean of |q_sim - q|, whole log open loop
};

struct FittedServo {
  Servo servo;
  std::string friction_model;    ///< "m1" to "m6"; empty if no fit wrote the file
  double encoder_offset = 0;     ///< [rad] of the bench that the logs come from, not of the servo
  std::string base, prior;       ///< servo type of firmware and voltage; name of the prior
  std::vector<LogError> fitted;  ///< logs that it was fitted to
};

/// The servo called `type`, or in a file of that path, with or without [fit]; only servo, friction_model and
/// encoder_offset are read. Throws SetupError.
[[nodiscard]] FittedServo read_fitted_servo(std::string_view type);

/// A servo file with comments. The same result gives the same text.
[[nodiscard]] std::string to_toml(const FittedServo& fitted);

}  // namespace murosimf::identification
