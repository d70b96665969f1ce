/// robot.h - a robot of a scene: its level of detail, joints, commands, motions, sensors and control software.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control.h"
#include "murosimf/kinematics.h"
#include "murosimf/sensors.h"
#include "murosimf/world.h"

namespace murosimf {
inline namespace v0 {

struct JointInfo {
  std::string name;
  std::string unit;             ///< "rad" or "m"
  double lower = 0, upper = 0;  ///< [unit] range; infinite if the model has none
};

/// Rows of joints have one number for each, in the order of joints().
class MUROSIMF_API Robot : public EntityHandle {
 public:
  /// `kinematic_walking`, `simplified_dynamics`, `full_dynamics`, `articulated_dynamics`.
  [[nodiscard]] const std::string& level() const;
  /// Changes the level during the motion. Throws UnknownName; InputError if the level refuses, without any change.
  void set_level(const std::string& level);

  [[nodiscard]] const std::vector<JointInfo>& joints() const;
  // State of the joints: [rad | m], [rad/s | m/s], [N m | N], [rad | m]. The memory stays where it is as long as a handle of the
  // scene lives; its numbers are those of the last of these calls, for whichever handle of the robot. NaN: the level has none.
  [[nodiscard]] std::span<const double> joint_position() const;
  [[nodiscard]] std::span<const double> joint_velocity() const;
  [[nodiscard]] std::span<const double> joint_torque() const;
  [[nodiscard]] std::span<const double> joint_target() const;

  // Throw InputError: not finite, or not one number for each joint.
  void set_joint_position(std::span<const double> positions);
  void set_joint_velocity(std::span<const double> velocities);
  /// Targets, as control software sets them. Throws InputError, too, if a controller of the scene writes the targets in every step.
  void set_joint_target(std::span<const double> targets);

  /// [m/s] forward, [m/s] to the left, [rad/s] turning: for controllers that walk. Throws InputError if no controller of the robot walks.
  void set_command(double forward, double left, double turning);
  /// Motions of the robot's file, by name; play() has the controller `motions` play one. Throw UnknownName, InputError.
  [[nodiscard]] std::vector<std::string> motions() const;
  void play(const std::string& motion);
  /// How often its base has tilted over 60 degrees so far, and whether it lies now.
  [[nodiscard]] int falls() const;
  [[nodiscard]] bool fallen() const;

  /// Names of sensors and cameras. sensor() and camera() throw UnknownName, camera() InputError if the scene has begun without that camera.
  [[nodiscard]] std::vector<std::string> sensors() const;
  [[nodiscard]] Sensor sensor(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> cameras() const;
  [[nodiscard]] Camera camera(std::string_view name) const;

  /// Calls the controller `rate` times per simulated second [Hz] from now on, instead of the previous one; null: none. Throws InputError for an
  /// impossible rate, and if a controller of the scene writes the joints' targets ("none" does not).
  void set_controller(std::shared_ptr<Controller> controller, double rate = 100);

  [[nodiscard]] Kinematics kinematics() const;

 private:
  friend class Scene;
  friend class Batch;
  using EntityHandle::EntityHandle;
};

}  // namespace v0
}  // namespace murosimf
