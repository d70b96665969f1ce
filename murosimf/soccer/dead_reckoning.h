/// dead_reckoning.h - how a walking robot moved, as it may believe itself: no sensor looks at the ground.
///
/// Forward and sideways as the walk intends (`gait_velocity`), turned as the inertial sensor says. Slipping, swaying and a
/// walk that does not do what it is told are what is missing.
#pragma once

#include "murosimf/model/properties.h"
#include "murosimf/model/setup.h"
#include "murosimf/soccer/planar.h"

namespace murosimf::soccer {

/// The pose of the robot after a time `dt` [s], in the frame of the pose before. `velocity` [m/s] forward, left;
/// `turned` [rad]. The way is an arc of a circle.
[[nodiscard]] inline Vec3d step_along(const Vec3d& velocity, double turned, double dt) noexcept {
  const Vec3d way = from_frame({0, 0, 0.5 * turned}, {dt * velocity.x, dt * velocity.y, 0});  // along the chord
  return {way.x, way.y, turned};
}

}  // namespace murosimf::soccer
