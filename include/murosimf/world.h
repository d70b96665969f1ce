/// world.h - robots, ball, bodies and field by name: poses, velocities, contacts, and properties by their names.
///
/// A handle is a small value. It keeps the scene alive inside the library and stays valid when entities are added, leave or are exchanged, and after
/// its Scene was moved. Handles of one scene are for one thread at a time, and to be used between two steps.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/values.h"

namespace murosimf {

namespace api {
struct SceneInside;
struct ViewInside;
}  // namespace api

inline namespace v0 {

/// All rows of a property as numbers in memory, to read and to write: number (i, j) of row r stands at
/// data[r * strides[0] + i * strides[1] + j * strides[2]]. Rows are the objects of the entity, in the order of EntityHandle::objects();
/// properties of the whole entity have one row. It keeps its memory, also after an exchange of the level; then it shows
/// the last values if nothing uses the property any more. Written values take effect in the next step of the level.
struct PropertyView {
  double* data = nullptr;
  std::size_t rows = 0;
  std::size_t shape[2] = {0, 0};          ///< of one value: {3, 3} of a matrix (row by row), {3, 1} of a vector, {1, 1}
  std::ptrdiff_t strides[3] = {0, 0, 0};  ///< [numbers]
  std::string_view unit, frame, meaning;
  std::shared_ptr<const api::ViewInside> keeps;

  [[nodiscard]] double& operator()(std::size_t row, std::size_t i = 0, std::size_t j = 0) const {
    return data[static_cast<std::ptrdiff_t>(row) * strides[0] + static_cast<std::ptrdiff_t>(i) * strides[1] +
                static_cast<std::ptrdiff_t>(j) * strides[2]];
  }
};

/// A robot, the ball, a body or the field.
class MUROSIMF_API EntityHandle {
 public:
  // moving copies: no handle is ever empty
  EntityHandle(const EntityHandle&) = default;
  EntityHandle& operator=(const EntityHandle&) = default;

  [[nodiscard]] const std::string& name() const;
  /// Names of the objects of its model, the base first, parents before children.
  [[nodiscard]] std::vector<std::string> objects() const;
  /// Whether it is there (Scene::enter, Scene::leave).
  [[nodiscard]] bool present() const;
  /// Why it was taken out of the simulation, which happens when its state is not plausible any more; empty: it was not.
  [[nodiscard]] std::string frozen() const;

  // Of the base, or of an object by its name; world frame. Throw UnknownName.
  [[nodiscard]] Pose pose() const;
  [[nodiscard]] Pose pose(std::string_view object) const;
  [[nodiscard]] Velocity velocity() const;
  [[nodiscard]] Velocity velocity(std::string_view object) const;

  /// Of the base; joints keep their positions. Throw InputError: not finite, no unit quaternion.
  void set_pose(const Pose& pose);
  void set_velocity(const Velocity& velocity);
  /// Puts a robot or ball down: upright, at rest, its lowest point at `position.z`, turned by `heading` [rad] about the
  /// vertical. Throws InputError if its level cannot begin so.
  void place(const Vector3& position, double heading = 0);
  /// Pushes for `duration` [s] from now on, with `force` [N] and `moment` [N m], world axes, at the object's center of mass; no object: the base.
  /// Throws UnknownName; InputError if its level ignores forces.
  void push(std::string_view object, const Vector3& force, double duration, const Vector3& moment = {});
  /// The law of contact with the ground, by its name.
  [[nodiscard]] const std::string& contact_law() const;
  void set_contact_law(const std::string& law);

  /// A property of an object by the names of `murosimf list properties`, variable or of the model; matrices row by row.
  [[nodiscard]] std::vector<double> get(std::string_view object, std::string_view property) const;
  /// Also constants of the model, which act from the next step on as if the scene had been built with them: mass, joint_damping,
  /// and of servos "servo.stall_torque"; a reset takes them back. Throws UnknownName, InputError.
  void set(std::string_view object, std::string_view property, std::span<const double> values);
  /// SI unit; "1" for pure numbers.
  [[nodiscard]] std::string unit(std::string_view object, std::string_view property) const;
  /// Names of all properties of an object that get() takes.
  [[nodiscard]] std::vector<std::string> properties(std::string_view object) const;
  /// Throws InputError if nothing uses the property, or if its values are no rows of numbers.
  [[nodiscard]] PropertyView view(std::string_view property) const;

 protected:
  friend class Scene;
  friend class Batch;
  EntityHandle(std::shared_ptr<api::SceneInside> scene, int number) : scene_(std::move(scene)), number_(number) {}

  std::shared_ptr<api::SceneInside> scene_;
  int number_ = 0;  // in the world, where it stays
};

/// A point where two bodies touch, of the last step.
struct Contact {
  std::string a, a_object;  ///< entity and object
  std::string b, b_object;  ///< the field, or another entity (or the same one, if it touches itself)
  Vector3 point;            ///< [m] world
  Vector3 normal;           ///< [1] unit, world, from b to a
  Vector3 force;            ///< [N] on a at `point`, world; b feels its opposite
  double depth = 0;         ///< [m] overlap along the normal, positive
};

/// What a ray meets first.
struct RayHit {
  std::string entity, object;
  double distance = 0;  ///< [m] from the ray's origin
  Vector3 point;        ///< [m] world
  Vector3 normal;       ///< [1] unit, outwards, world
};

}  // namespace v0
}  // namespace murosimf
