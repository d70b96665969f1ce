/// inertial.h - sensors: gyroscope, accelerometer, orientation, and the three of them in one part (imu).
///
/// In axes of the sensor, R its orientation in the world, r the place where it is mounted, h a step of the simulation,
/// T = n h the time between two samples:
///
///     gyroscope       w_s = R^T w                                                            [rad/s]
///     accelerometer   f_s = 1/n sum_k=0..n-1 f(t - k h)                                      [m/s^2]
///                     f(t) = (R(t) + R(t - h))^T/2 ((v(t) - v(t - h))/h - g),  v = r'
///     orientation     q, sensor axes to world axes                                           w x y z
///
/// The accelerometer shows specific force: +9.81 up at rest, 0 in free fall (REP-145). It is the mean over the period
/// that ends at the sample, from velocities: what strapdown navigation calls an increment of velocity, divided by T. So
/// nothing between two samples is lost or counted twice: samples add up to the change of velocity, whatever the rate
/// is. The value of a single step would be aliased. A kinematic walker's velocity is a staircase with the steps of its
/// controller, and jumps when the feet swap: samples in phase with the controller see the same part of each stair (at
/// 100 Hz the mean of a walk was 5.7 m/s^2 off); under a contact law one step in T / h shows an impact, T / h times too
/// strong. Real parts decimate in the same way. It is the same equation at every level. Impacts are seen as peaks of
/// jump / T; a part's own low-pass works on the moving mean over T. The first sample comes after a first period, as
/// before there is no change; until then the reading shows what a sensor at rest would.
/// Errors of the orientation (noise, bias, drift; all [rad]) are a rotation vector e in sensor axes: q exp(e).
/// Source: Titterton, Weston, Strapdown Inertial Navigation Technology, ch. 2 (specific force), ch. 11 (increments).
#pragma once

#include <vector>

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

/// Specific force at a mounting, as the mean over the last `window`.
class SpecificForce {
 public:
  SpecificForce(Setup& setup, const SensorSpec& spec, Duration window);
  void start() noexcept { calls_ = 0; }
  /// To be called in every step. The first time it is NaN; then the mean since the start, until a window is full.
  [[nodiscard]] Vec3d next() noexcept;
  [[nodiscard]] bool ready() const noexcept { return calls_ > 1; }
  /// Sensor axes to world axes when next() was called last.
  [[nodiscard]] const Mat3d& orientation() const noexcept { return last_orientation_; }
  [[nodiscard]] Vec3d at_rest() const noexcept { return transpose(mounting_.orientation()) * -gravity_; }

  void state(StateArchive& archive);

 private:
  [[nodiscard]] Vec3d of_step() noexcept;
  void put_in(const Vec3d& force) noexcept;

  Mounting mounting_;
  Vec3d gravity_;  // [m/s^2]
  double period_;  // [s]
  Vec3d last_velocity_;
  Mat3d last_orientation_;
  std::vector<Vec3d> window_;  // a ring of the last steps
  Vec3d sum_;                  // of the window
  std::uint64_t calls_ = 0;
};

class Accelerometer final : public Sensor {
 public:
  Accelerometer(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
  void start() noexcept override { force_.start(); }
  void memory(StateArchive& archive) override { archive(force_); }
  [[nodiscard]] bool ready() const noexcept override { return force_.ready(); }
  void expect(std::span<double> values) const noexcept override;

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
  void memory(StateArchive& archive) override { archive(force_); }
  [[nodiscard]] bool ready() const noexcept override { return force_.ready(); }
  void expect(std::span<double> values) const noexcept override;

  Mounting mounting_;
  SpecificForce force_;
};

}  // namespace murosimf::sensors
