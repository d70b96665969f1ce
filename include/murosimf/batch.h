/// batch.h - many worlds of one scene, stepped together by a pool of threads, as for learning.
///
///     murosimf::Batch batch("walk", 1024, {.set = {"walker.level=simplified_dynamics", "walker.controller=none"}}, 2);
///     batch.set_joint_target(actions);   // (worlds, joints), row by row
///     batch.step(20);
///     const auto seen = batch.observe({"base.gravity", "base.angular_velocity", "joint_position", "joint_velocity", "last_action"});
///
/// Robot files are read once. World i begins with the seed of the scene plus i, and gives the states that a Scene with that seed gives alone,
/// bit for bit, for any number of worlds and threads. Rows are one for each world, of its first robot.
///
/// Eight worlds at a time are stepped in lanes, as equal robots of one scene are, and the others wait as packed states of a few KiB. So
/// many steps at once, as between two actions of a policy, cost less for each than one by one. Worlds with events, with control
/// software from outside, and those that world() has given away are scenes of their own, which step by themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/scene.h"

namespace murosimf {

namespace api {
class BatchInside;
}

inline namespace v0 {

/// A property of the robot that differs from world to world. Evenly distributed from `low` to `high`, each number by itself.
struct Randomized {
  std::string property;      ///< as in Batch::observe(): "supply_voltage", "torso.applied_force"
  double low = 1, high = 1;  ///< [1], or in units of the property
  bool scales = true;        ///< multiplies what the start gives; false: takes its place
};

class MUROSIMF_API Batch {
 public:
  /// Of a file or name, as Scene. `options.threads` are those of one world, `threads` those that all worlds share. Throws InputError.
  Batch(const std::string& scene, std::size_t worlds, const SceneOptions& options = {}, int threads = 1);
  ~Batch();
  Batch(Batch&&) noexcept;
  Batch& operator=(Batch&&) noexcept;

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] double step_length() const;  ///< [s]
  /// One of the worlds, as a scene; it shares it. While step() works nothing else uses it. Throws InputError beyond the last.
  [[nodiscard]] Scene world(std::size_t number) const;

  /// Equal states have equal hashes; that of a Scene in the same state. Throws InputError beyond the last.
  [[nodiscard]] std::uint64_t state_hash(std::size_t world) const;

  void step(int steps = 1);
  /// Resets the worlds with a nonzero entry, or all if there are no entries, to `seed` plus their number.
  void reset(std::span<const std::uint8_t> which = {});
  void reset(std::uint64_t seed, std::span<const std::uint8_t> which = {});

  /// From its next reset on a world has these numbers at its start, which follow from its seed and the names alone. In place of those of an
  /// earlier call. What a level or sensor writes in every step does not keep them; constants of the model, such as masses, are the same in
  /// all worlds. Throws UnknownName and InputError.
  void randomize(const std::vector<Randomized>& properties);

  [[nodiscard]] std::size_t joints() const;
  // (worlds, joints), [rad | m] and [rad/s | m/s]; the memory stays where it is as long as the batch lives, and is renewed by each call.
  [[nodiscard]] std::span<const double> joint_position();
  [[nodiscard]] std::span<const double> joint_velocity();
  /// (worlds, 7): position [m] and orientation (w, x, y, z) of the base, world frame; likewise.
  [[nodiscard]] std::span<const double> base_pose();
  /// (worlds, 6): linear [m/s] and angular [rad/s] velocity of the base, world axes; likewise.
  [[nodiscard]] std::span<const double> base_velocity();
  /// (worlds): 1 for robots that lie.
  [[nodiscard]] std::span<const std::uint8_t> fallen();
  // (worlds, 3): center [m] and velocity [m/s] of the ball, world frame; likewise. Throw UnknownName if there is none.
  [[nodiscard]] std::span<const double> ball_position();
  [[nodiscard]] std::span<const double> ball_velocity();
  /// (worlds, joints), likewise: what the servos are told, from the next step on if set_joint_target() has given it. At a level without
  /// targets: the positions.
  [[nodiscard]] std::span<const double> joint_target();
  /// (worlds, joints). Throws as Robot::set_joint_target.
  void set_joint_target(std::span<const double> targets);

  /// (worlds, numbers of these names): what a policy sees, one after the other, as it was after the last step() or reset(); memory as of
  /// the rows above. A name is
  ///     base.gravity, base.linear_velocity, base.angular_velocity   3 numbers in axes of the base: where gravity points to [1], [m/s], [rad/s]
  ///     joint_position, joint_velocity, ...                         a property of all joints, in the order of joint_position()
  ///     last_action                                                 the joint targets
  ///     common_center_of_mass, lying, ...                           a property that the robot has once
  ///     torso.position, l_foot.linear_velocity, ...                 a property of one object (`murosimf list properties`)
  /// Asking for other names than before looks at all worlds; the same ones again cost nothing. Throws UnknownName.
  [[nodiscard]] std::span<const float> observe(const std::vector<std::string>& names);

  /// Pushes the robot of one world for `duration` [s] from now on, as Entity::push: with `force` [N] and `moment` [N m], world axes, at the
  /// center of mass of the object; "": the base. Throws UnknownName, and InputError at a level that feels no forces.
  void push(std::size_t world, std::string_view object, const Vector3& force, double duration,
            const Vector3& moment = {});

  /// From now on the robot is at this level in all worlds, which begin anew, each as a Scene that was opened with that level. Throws
  /// InputError, and changes nothing, for one that does not exist or cannot move the robot.
  void set_level(const std::string& level);

 private:
  [[nodiscard]] api::BatchInside& inside() const;
  void check(std::size_t world) const;
  std::unique_ptr<api::BatchInside> inside_;
};

}  // namespace v0
}  // namespace murosimf
