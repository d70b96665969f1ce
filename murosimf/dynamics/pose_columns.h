/// pose_columns.h - the columns that every level of detail writes: where the robot is and how it moves.
#pragma once

#include <span>

#include "murosimf/model/properties.h"
#include "murosimf/world/motion_level.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

struct PoseColumns {
  explicit PoseColumns(Setup& setup);

  /// Poses of all objects from row 0 and the joint positions.
  void update_poses() noexcept;
  /// Velocities of all objects from row 0, the poses and the joint rates.
  void update_velocities() noexcept;
  /// Momentum of all links for the present columns.
  [[nodiscard]] Momentum momentum() const;
  /// Sets all velocities to zero: the motion of a frozen entity, as others see it.
  void stop() noexcept;

  // Levels derive the base's position and velocity from other state. So that users can nevertheless change them by name,
  // a level stores what it wrote and takes over the difference at its next step; no change gives exactly 0.
  void remember_base() noexcept;
  [[nodiscard]] Vec3d take_displacement() noexcept;     ///< [m]
  [[nodiscard]] Vec3d take_velocity_change() noexcept;  ///< [m/s]

  const Model& model;
  std::span<Vec3d> r;        ///< [m] origin of each object, world
  std::span<Mat3d> R;        ///< orientation of each object
  std::span<Vec3d> v;        ///< [m/s] of each origin, world
  std::span<Vec3d> w;        ///< [rad/s] of each object, world
  std::span<double> q;       ///< [rad | m] joint positions
  std::span<double> qd;      ///< [rad/s | m/s] joint rates
  std::span<Quaterniond> Q;  ///< base orientation
  Vec3d& written_r;          ///< [m] base position as the level left it
  Vec3d& written_v;          ///< [m/s] base velocity as the level left it
};

/// Places the robot as its entity's options say: base above (x, y), first sole flat and heading as given (base upright
/// if the model has no soles), lowest point of the robot at height z. Of a robot whose base is bolted to the world (model/fixed_base.h)
/// the base itself is upright, at height z. Joint positions must be set; velocities become 0.
void place_at_start(PoseColumns& columns, const Entity& entity) noexcept;

}  // namespace murosimf::dynamics
