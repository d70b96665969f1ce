/// kinematics.h - kinematics and dynamics of a robot's model for any joint positions, independent of its state in the scene.
///
/// `q`, `v`, `a` are rows with one number for each joint, in the order of Robot::joints(), [rad | m] and rates; one row or several, one
/// after the other, each of which is computed by itself. All results are in the frame of the base, which rests. Rotors of
/// motors are left out. Sources: Featherstone, Rigid Body Dynamics Algorithms, 2008, ch. 4 and 5, sec. 6.2. All throw InputError for
/// rows of the wrong length and UnknownName for objects.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/values.h"

namespace murosimf {

namespace api {
struct KinematicsInside;
}

inline namespace v0 {

class MUROSIMF_API Kinematics {
 public:
  // moving copies: no handle is ever empty
  Kinematics(const Kinematics&) = default;
  Kinematics& operator=(const Kinematics&) = default;

  [[nodiscard]] std::size_t joints() const;
  /// [kg] of the whole robot.
  [[nodiscard]] double mass() const;

  /// Poses of an object, one for each row of q.
  [[nodiscard]] std::vector<Pose> poses(std::span<const double> q, std::string_view object) const;
  /// Centers of mass of the whole robot [m], one for each row of q.
  [[nodiscard]] std::vector<Vector3> centers_of_mass(std::span<const double> q) const;
  /// (rows, 6, joints), row by row: velocity of an object's origin per joint rate, linear [m/s] first, then angular [rad/s].
  [[nodiscard]] std::vector<double> jacobians(std::span<const double> q, std::string_view object) const;
  /// (rows, 6 + joints, 6 + joints): the base's angular velocity, its linear velocity, then the joints; moments are taken at the base's
  /// origin.
  [[nodiscard]] std::vector<double> mass_matrices(std::span<const double> q) const;
  /// (rows, joints) [N m | N] joint torques and forces of the motion, if the base is held; `gravity` [m/s^2] in the base's axes.
  [[nodiscard]] std::vector<double> inverse_dynamics(std::span<const double> q, std::span<const double> v,
                                                     std::span<const double> a,
                                                     const Vector3& gravity = {0, 0, -9.81}) const;

 private:
  friend class Robot;
  explicit Kinematics(std::shared_ptr<const api::KinematicsInside> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<const api::KinematicsInside> inside_;
};

}  // namespace v0
}  // namespace murosimf
