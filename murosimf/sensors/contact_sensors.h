/// contact_sensors.h - sensors: contact switch, contact force, force and torque (6 axes), pressure cells and center of
/// pressure of a foot.
///
/// All of them feel the contacts (ground, things, other robots, own limbs; not a user's pushes) of everything that is
/// rigidly fixed to the link that they are mounted on. In axes of the sensor, at its place p:
///
///     F = R^T sum f_k        N = R^T sum (n_k + (r_k - p) x f_k)       over the bodies k of the link
///     contact_switch    |F| > threshold                                                          1 or 0
///     contact_force     |F|                                                                      [N]
///     force_torque      F, N                                                                     [N], [N m]
///     pressure_center   x = -N_y/F_z, y = N_x/F_z where the force goes through z = 0; F_z        [m], [N]
///     pressure_cells    F_z (1/2 +- x/length) (1/2 +- y/width): four cells at the corners of a rectangle, with x and y
///                       of the center of pressure kept within it                                 [N]
///
/// The forces are those that acted in the step that ends at the sample. The cells add up to F_z, and their center is the
/// center of pressure as long as that lies between them: the foot is a stiff plate on four springs of equal stiffness
/// whose redundant (twisting) mode is the bilinear one. Below the threshold nothing presses: the cells are 0 and the
/// center of pressure is NaN.
/// kinematic_walking has no contact forces. There the link with the standing sole is reported to carry the whole weight,
/// upwards, in the middle of that sole; all others nothing.
/// Source: center of pressure: Sardain, Bessonnet, "Forces acting on a biped robot. Center of pressure - zero moment
/// point", IEEE Trans. SMC A 34 (2004).
#pragma once

#include <optional>

#include "murosimf/math/spatial.h"
#include "murosimf/model/feet.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"
#include "murosimf/sensors/sensor_options.h"

namespace murosimf::sensors {

struct ContactSensorOptions {
  double threshold = 0.1;  ///< [N]
};

struct PressureCellsOptions {
  double threshold = 0.1;                   ///< [N]
  std::optional<double> length{}, width{};  ///< [m] between the cells; nothing: those of the sole
};

[[nodiscard]] const OptionTable<ContactSensorOptions>& contact_sensor_options();
[[nodiscard]] const OptionTable<PressureCellsOptions>& pressure_cells_options();

/// The contacts of one link.
class ContactLoad {
 public:
  ContactLoad(Setup& setup, const SensorSpec& spec);
  /// [N m, N] in axes of the sensor, at its place.
  [[nodiscard]] Wrenchd load() const noexcept;

 private:
  [[nodiscard]] Wrenchd carried_weight() const noexcept;

  const Model& model_;
  Mounting mounting_;
  std::vector<int> bodies_;  // of the link
  std::vector<Foot> feet_;   // of the model
  Vec3d weight_;             // [N] world, what carries the robot
  std::span<const Vec3d> r_;
  std::span<const Mat3d> R_;
  std::span<const Wrenchd> external_, applied_;
  std::span<const double> dynamic_, stance_foot_;
};

/// Common to all of this page.
class ContactSensor : public Sensor {
 public:
  [[nodiscard]] std::string diagnostic(const LevelTraits& level) const override;

 protected:
  ContactSensor(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings,
                std::vector<Output> outputs);

  ContactLoad load_;
  double threshold_;  // [N]
};

class ContactSwitch final : public ContactSensor {
 public:
  ContactSwitch(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
};

class ContactForce final : public ContactSensor {
 public:
  ContactForce(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
};

class ForceTorque final : public ContactSensor {
 public:
  ForceTorque(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
};

class PressureCenter final : public ContactSensor {
 public:
  PressureCenter(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;
};

class PressureCells final : public ContactSensor {
 public:
  /// Throws SetupError if it is not mounted on a sole and has no size.
  PressureCells(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings);

 private:
  void measure(std::span<double> values) noexcept override;

  double length_ = 0, width_ = 0;  // [m]
};

}  // namespace murosimf::sensors
