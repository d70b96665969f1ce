/// mounting.h - where a sensor is and how it moves: a frame that is fixed to a link of a robot.
#pragma once

#include <span>

#include "murosimf/sensors/sensor_spec.h"
#include "murosimf/world/setup.h"

namespace murosimf::sensors {

class Mounting {
 public:
  /// Reads pose and velocity of the link. Throws SetupError if the model has no object `spec.frame`.
  Mounting(Setup& setup, const SensorSpec& spec);

  [[nodiscard]] Mat3d orientation() const noexcept { return R_[link_] * turn_; }  ///< sensor axes to world axes
  [[nodiscard]] Vec3d position() const noexcept { return r_[link_] + arm(); }     ///< [m] world
  [[nodiscard]] Vec3d velocity() const noexcept { return v_[link_] + cross(w_[link_], arm()); }  ///< [m/s] world
  [[nodiscard]] Vec3d angular_velocity() const noexcept { return w_[link_]; }                    ///< [rad/s] world axes
  [[nodiscard]] int link_object() const { return link_; }                   ///< base or joint that it moves with
  [[nodiscard]] const Vec3d& position_on_link() const { return offset_; }   ///< [m] frame of the link
  [[nodiscard]] const Mat3d& orientation_on_link() const { return turn_; }  ///< sensor axes to those of the link

 private:
  [[nodiscard]] Vec3d arm() const noexcept { return R_[link_] * offset_; }

  int link_ = 0;  // the link's object
  Vec3d offset_;  // [m] in the link's frame
  Mat3d turn_;    // sensor axes to the link's
  std::span<const Vec3d> r_, v_, w_;
  std::span<const Mat3d> R_;
};

/// The sensor's axes to those of its frame, with the mounting error: a turn of the axes that the sensor should have, by
/// roll, pitch and yaw about these.
[[nodiscard]] Mat3d true_orientation(const SensorSpec& spec);

/// Object that a sensor is mounted on: `spec.frame`, or the base.
[[nodiscard]] int mounted_on(const Model& model, const SensorSpec& spec);

}  // namespace murosimf::sensors
