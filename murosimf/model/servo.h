/// servo.h - data of a servo motor, on the output side of its gear. What moves with it is motion's business.
#pragma once

#include <string>

namespace murosimf {

struct Servo {
  std::string type;             ///< name of the table it came from, for example "mx64"
  double stall_torque = 0;      ///< [N m]
  double no_load_rate = 0;      ///< [rad/s]
  double position_gain = 0;     ///< [N m/rad]
  double rotor_inertia = 0;     ///< [kg m^2]
  double coulomb_friction = 0;  ///< [N m]
};

}  // namespace murosimf
