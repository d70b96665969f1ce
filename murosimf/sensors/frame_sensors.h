/// frame_sensors.h - sensors without a real part: where the sensor is and how it moves, exactly (paper 6.3).
///
///     position           of the sensor, world                                          [m]
///     linear_velocity    of the sensor, world axes                                     [m/s]
///     velocimeter        the same in axes of the sensor                                [m/s]
///     angular_velocity   world axes (gyroscope: in axes of the sensor)                 [rad/s]
///     center_of_mass     common one of the robot, world, and its velocity              [m], [m/s]
///
/// Noise and bias make rough sensors of them: a position with noise stands for a tracking system.
#pragma once

#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::sensors {

class Position final : public Sensor {
 public:
  Position(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;

  Mounting mounting_;
};

class LinearVelocity final : public Sensor {
 public:
  LinearVelocity(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;

  Mounting mounting_;
};

class Velocimeter final : public Sensor {
 public:
  Velocimeter(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;

  Mounting mounting_;
};

class AngularVelocity final : public Sensor {
 public:
  AngularVelocity(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;

  Mounting mounting_;
};

class CenterOfMass final : public Sensor {
 public:
  CenterOfMass(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;

  const Tree& tree_;
  std::span<const Vec3d> r_, v_, w_;
  std::span<const Mat3d> R_;
};

}  // namespace murosimf::sensors
