/// servo.h - data of a servo motor, on the output side of its gear. motion/ computes its torque.
///
/// Stall torque, no-load rate and gain hold at `voltage`; a servo law (dynamics/servo/servo_law.h) makes torque of them. The
/// textbook's constants of the motor, seen at the output, follow: k_t = voltage / no_load_speed [N m/A = V s/rad] and
/// R = k_t voltage / stall_torque [ohm].
#pragma once

#include <string>

namespace murosimf {

/// The largest torque of a gear's friction: a budget. The equation and its source are in
/// multibody/servo/gear_friction.h. The numbers without unit are shares of a load. All zero: none.
struct GearFriction {
  double coulomb = 0;                  ///< [N m] K_c
  double viscous = 0;                  ///< [N m s/rad] K_v
  double stribeck = 0;                 ///< [N m] K_cs: more at rest
  double stribeck_rate = 0;            ///< [rad/s] v_s; 0: nothing is more at rest
  double stribeck_exponent = 1;        ///< [1] alpha
  double motor_load = 0;               ///< [1] K_m: of the motor's torque
  double external_load = 0;            ///< [1] K_e: of the load's torque
  double stribeck_motor_load = 0;      ///< [1] K_ms
  double stribeck_external_load = 0;   ///< [1] K_es
  double quadratic_motor_load = 0;     ///< [1/(N m)] K_mq
  double quadratic_external_load = 0;  ///< [1/(N m)] K_eq
};

/// A servo's temperature: one body that is heated by its winding and cooled by the air. All zero: always 25 C.
struct ServoHeat {
  double heat_capacity = 0;         ///< [J/K]
  double thermal_resistance = 0;    ///< [K/W] from winding to air
  double ambient_temperature = 25;  ///< [C] of the air, and of a servo at the start
  double derating_temperature = 0;  ///< [C] above it the firmware gives less torque; 0: never
  double temperature_limit = 0;     ///< [C] where derating ends: no torque from here on
};

struct Servo {
  std::string type;              ///< name of the table it came from, for example "mx64"
  std::string law = "dc_motor";  ///< name of the servo law
  double voltage = 0;            ///< [V] supply; 0: not known
  double stall_torque = 0;       ///< [N m] at rest and full duty; 0: unlimited (ideal_pd only)
  double lowest_share = -1;      ///< [1] of stall_torque: the lowest torque that it gives (ideal_pd only)
  double highest_share = 1;      ///< [1] likewise, the highest
  double no_load_speed = 0;      ///< [rad/s] at full duty, without friction; 0: not known (ideal_pd only)
  double position_gain = 0;      ///< [N m/rad] torque at rest per angle between target and position
  double firmware_gain = 0;      ///< [1] the integer P gain of the firmware that gives position_gain; 0: not known
  double velocity_gain = 0;      ///< [N m s/rad] of the controller (ideal_pd only)
  double duty_limit = 1;         ///< [1] largest duty cycle that the firmware gives
  double torque_limit = 0;       ///< [N m] of the motor, from its current limit; 0: none
  double rotor_inertia = 0;      ///< [kg m^2]
  GearFriction friction;
  double backlash = 0;        ///< [rad] free play between motor and output, from one side to the other
  double encoder_step = 0;    ///< [rad] position and target are known in whole steps; 0: exactly
  double dead_band = 0;       ///< [rad] an error up to this counts as none; a larger one is as much smaller
  double command_period = 0;  ///< [s] a target is taken over every so often, and held; 0: at once
  double command_delay = 0;   ///< [s] from the controller's target to the motor
  double command_filter = 0;  ///< [s] time constant with which the motor comes to a target that arrives; 0: at once
  ServoHeat heat;
};

/// The moment of the largest excess of a motion over a servo's torque; all zero if there was none.
struct Overload {
  double needed = 0;  ///< [N m]
  double given = 0;   ///< [N m] what the servo can give at that rate
  double rate = 0;    ///< [rad/s]
  double time = 0;    ///< [s]
};

}  // namespace murosimf
