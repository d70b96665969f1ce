/// joint_sensors.h - sensors: what servos and joints report. One output, a number for each joint.
///
///     joint_position      q, of an encoder at the output side of the gear            [rad | m]
///     joint_velocity          q'                                                         [rad/s | m/s]
///     joint_torque        of servo and gear, as the joint feels it                   [N m | N]
///     motor_current       i = tau_m / k_t, tau_m the motor's torque before friction  [A]
///     motor_voltage       supply of the servo                                        [V]
///     motor_temperature   of its winding                                             [C]
///
/// k_t = voltage / no_load_speed on the output side of the gear (model/servo.h). Joints without such a servo show 0. Where
/// a level has no torque (kinematic_walking, simplified_dynamics) torque and current are 0, the voltage is the servo's own
/// and the temperature that of the air. full_dynamics has the torque that the motion would take; current follows it.
#pragma once

#include "murosimf/sensors/sensor.h"

namespace murosimf::sensors {

/// Joints that a sensor looks at, by name: those that the spec names, or all of the model, in its order. Throws SetupError
/// for a name that is no joint.
[[nodiscard]] std::vector<int> sensed_joints(const Model& model, const SensorSpec& spec);

/// Position or rate.
class JointSensor : public Sensor {
 protected:
  JointSensor(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings,
              const Property<double>& property, Output output);

 private:
  void measure(std::span<double> values) noexcept override;

  std::vector<int> joints_;
  std::span<const double> column_;
};

class JointPosition final : public JointSensor {
 public:
  JointPosition(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);
};

class JointRate final : public JointSensor {
 public:
  JointRate(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);
};

/// What only some levels know.
class ServoSensor : public Sensor {
 protected:
  ServoSensor(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings, Output output);
  /// [1] Factor and value without a level that has it, for each joint in turn.
  struct Joint {
    int object = 0;
    double factor = 1, otherwise = 0;
  };
  /// Values of a column, times the factors; `otherwise` where the level does not know one (NaN).
  void convert(std::span<double> values, std::span<const double> column) noexcept;

  std::vector<Joint> joints_;
};

class JointTorque final : public ServoSensor {
 public:
  JointTorque(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);
  [[nodiscard]] std::string diagnostic(const LevelTraits& level) const override;

 private:
  void measure(std::span<double> values) noexcept override { ServoSensor::convert(values, torque_); }

  std::span<const double> torque_;
};

class MotorCurrent final : public ServoSensor {
 public:
  MotorCurrent(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);
  [[nodiscard]] std::string diagnostic(const LevelTraits& level) const override;

 private:
  void measure(std::span<double> values) noexcept override;

  std::span<const double> motor_torque_, joint_torque_;
};

class MotorVoltage final : public ServoSensor {
 public:
  MotorVoltage(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override { ServoSensor::convert(values, voltage_); }

  std::span<const double> voltage_;
};

class MotorTemperature final : public ServoSensor {
 public:
  MotorTemperature(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);
  [[nodiscard]] std::string diagnostic(const LevelTraits& level) const override;

 private:
  void measure(std::span<double> values) noexcept override { ServoSensor::convert(values, temperature_); }

  std::span<const double> temperature_;
};

}  // namespace murosimf::sensors
