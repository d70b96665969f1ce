/// inertial.h - sensors: gyroscope, accelerometer, orientation, and the three of them in one part (imu).
///
/// In axes of the sensor, R its orientation in the world, r the place where it is mounted, h a step of the simulation:
///
///     gyroscope       w_s = R^T w                                                            [rad/s]
///     accelerometer   f_s = (R(t) + R(t - h))^T/2 ((v(t) - v(t - h))/h - g),  v = r'         [m/s^2]
///     orientation     q, sensor axes to world axes                                           w x y z
///
/// The accelerometer shows specific force: +9.81 up at rest, 0 in free fall (REP-145). It is the mean over the step that
/// ends at the sample, from velocities, so it is what the level's motion really was, impacts included, and the same
/// equation at every level. In the first step of a run there is no velocity before: it counts as unaccelerated.
/// A kinematic walker's velocity jumps when the feet swap, which shows as peaks of jump / h: give the part its low-pass.
/// Errors of the orientation (noise, bias, drift; all [rad]) are a rotation vector e in sensor axes: q exp(e).
/// Source: Titterton, Weston, Strapdown Inertial Navigation Technology, ch. 2 (specific force).
#pragma once

#include "murosimf/math/quaternion.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::sensors {

class Gyroscope final : public Sensor {
 public:
  Gyroscope(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;

  Mounting mounting_;
};

/// Specific force at a mounting, from one step to the next.
class SpecificForce {
 public:
  SpecificForce(Setup& setup, const SensorSpec& spec);
  void start() noexcept { steps_ = 0; }
  /// To be called in every step.
  [[nodiscard]] Vec3d next() noexcept;

 private:
  Mounting mounting_;
  Vec3d gravity_;  // [m/s^2]
  double period_;  // [s]
  Vec3d last_velocity_;
  Mat3d last_orientation_;
  std::uint64_t steps_ = 0;
};

class Accelerometer final : public Sensor {
 public:
  Accelerometer(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
  void start() noexcept override { force_.start(); }

  SpecificForce force_;
};

class Orientation final : public Sensor {
 public:
  Orientation(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
  void present(std::span<double> values) noexcept override;

  Mounting mounting_;
};

/// Outputs gyroscope, accelerometer and orientation.
class Imu final : public Sensor {
 public:
  Imu(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
  void present(std::span<double> values) noexcept override;
  void start() noexcept override { force_.start(); }

  Mounting mounting_;
  SpecificForce force_;
};

}  // namespace murosimf::sensors
