/// kinematics.h - kinematics and dynamics of a robot's model for any joint positions, apart from what it does in the scene.
///
/// `q`, `v`, `a` are rows with one number for each joint, in the order of Robot::joints(), [rad | m] and rates; one row or several, one
/// after the other, of which each is worked out by itself. Everything stands in the frame of the base, which rests. Rotors of
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

  /// Of an object, one for each row of q.
  [[nodiscard]] std::vector<Pose> poses(std::span<const double> q, std::string_view object) const;
  /// Of the whole robot [m], one for each row of q.
  [[nodiscard]] std::vector<Vector3> centers_of_mass(std::span<const double> q) const;
  /// (rows, 6, joints), row by row: what joint rates make of an object's origin, linear velocity [m/s] first, then angular [rad/s].
  [[nodiscard]] std::vector<double> jacobians(std::span<const double> q, std::string_view object) const;
  /// (rows, 6 + joints, 6 + joints): the base's angular velocity, its linear velocity, then the joints; moments are taken at the base's
  /// origin.
  [[nodiscard]] std::vector<double> mass_matrices(std::span<const double> q) const;
  /// (rows, joints) [N m | N] that the motion takes of the joints, if the base is held; `gravity` [m/s^2] in the base's axes.
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
