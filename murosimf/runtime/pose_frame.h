/// pose_frame.h - the poses of all entities at one moment, for observers in other threads: viewers, recorders, servers.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "murosimf/math/mat3.h"
#include "murosimf/world/time.h"

namespace murosimf {

class World;

/// A point where something touches something.
struct ContactMark {
  Vec3d point;  ///< [m] world
  Vec3d force;  ///< [N] on the entity that the contact belongs to, world
  int ground_contact_of =
      -1;  ///< entity that touches the ground there, by its place in the world; -1: two entities touch
};

/// A copy: it stays as it is while the simulation goes on.
struct PoseFrame {
  Duration time{};        ///< simulated, at the end of the step
  std::int64_t tick = 0;  ///< `time` in ticks (Simulation::tick)
  /// By entity, in the order of the world: the number of its first object in what follows, and one more entry for the end.
  std::vector<std::size_t> first;
  std::vector<Vec3d> position;         ///< [m] of each object's origin, world
  std::vector<Mat3d> orientation;      ///< of each object, to world
  std::vector<double> joint_position;  ///< [rad | m] of each object, 0 of those that are no joints
  std::vector<bool> frozen, present;   ///< by entity (world/entity.h)
  std::vector<ContactMark> contacts;   ///< empty if the reader has not asked for them
};

/// Adds the contacts of all entities.
using ContactSource = std::function<void(const World&, std::vector<ContactMark>&)>;

/// Computes the poses that follow from bases and joints, which may have been changed.
using FrameCompletion = std::function<void(const World&, PoseFrame&)>;

/// Copies what the columns have now. Entities that nothing moves have unit poses. Allocates only if `frame` is too small.
void take_poses(const World& world, PoseFrame& frame);

}  // namespace murosimf
