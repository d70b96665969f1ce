/// batch.h - many worlds of one scene, stepped together by a pool of threads, as for learning.
///
///     murosimf::Batch batch("walk", 1024, {.set = {"walker.level=simplified_dynamics", "walker.controller=none"}}, 2);
///     batch.set_joint_target(actions);   // (worlds, joints), row by row
///     batch.step(20);
///     const auto q = batch.joint_position();
///
/// Robot files are read once. World i begins with the seed of the scene plus i, and gives the states that a Scene with that seed gives alone,
/// bit for bit, for any number of threads. Rows are one for each world, of its first robot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "murosimf/scene.h"

namespace murosimf {

namespace api {
class BatchInside;
}

inline namespace v0 {

class MUROSIMF_API Batch {
 public:
  /// Of a file or name, as Scene. `options.threads` are those of one world, `threads` those that all worlds share. Throws InputError.
  Batch(const std::string& scene, std::size_t worlds, const SceneOptions& options = {}, int threads = 1);
  ~Batch();
  Batch(Batch&&) noexcept;
  Batch& operator=(Batch&&) noexcept;

  [[nodiscard]] std::size_t size() const;
  /// One of the worlds as a scene, shared with the batch. It must not be used during step(). Throws InputError beyond the last.
  [[nodiscard]] Scene world(std::size_t number) const;

  /// Equal states have equal hashes; that of a Scene in the same state. Throws InputError beyond the last.
  [[nodiscard]] std::uint64_t state_hash(std::size_t world) const;

  void step(int steps = 1);
  /// Resets the worlds with a nonzero entry, or all if there are no entries, to `seed` plus their number.
  void reset(std::span<const std::uint8_t> which = {});
  void reset(std::uint64_t seed, std::span<const std::uint8_t> which = {});

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
  /// (worlds, joints). Throws as Robot::set_joint_target.
  void set_joint_target(std::span<const double> targets);

 private:
  [[nodiscard]] api::BatchInside& inside() const;
  void check(std::size_t world) const;
  std::unique_ptr<api::BatchInside> inside_;
};

}  // namespace v0
}  // namespace murosimf
