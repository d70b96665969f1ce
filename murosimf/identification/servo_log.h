/// servo_log.h - a recording of a servo that swings a pendulum.
#pragma once

#include <string>
#include <vector>

namespace murosimf::identification {

/// One entry of a log.
struct ServoSample {
  double time = 0;      ///< [s] from the first entry; grows from entry to entry
  double position = 0;  ///< [rad] of the encoder
  double rate = 0;      ///< [rad/s] as the servo reports it: filtered, it lags
  double voltage = 0;   ///< [V] of the supply, > 0
  double goal = 0;      ///< [rad]
  bool enabled = true;  ///< false: torque is off, the bridge is open
};

struct ServoLog {
  std::string name;                  ///< of the file, without folder and extension
  std::string motor;                 ///< name in the log; may be empty
  std::string trajectory;            ///< name in the log; may be empty
  double mass = 0;                   ///< [kg] at the end of the arm
  double length = 0;                 ///< [m] of the arm
  double arm_mass = 0;               ///< [kg] of the arm, a uniform rod
  double firmware_gain = 0;          ///< [1] P gain in the servo's register
  std::vector<ServoSample> samples;  ///< at least two
};

}  // namespace murosimf::identification
