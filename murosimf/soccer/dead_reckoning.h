/// dead_reckoning.h - motion of a walking robot as estimated by itself, without a sensor of the ground.
///
/// Forward and sideways by the velocity of the gait (`gait_velocity`), turned by the inertial sensor. Slipping, swaying and
/// deviations of the walk from its command are errors of the estimate.
#pragma once

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/soccer/planar.h"
#include "murosimf/world/setup.h"

namespace murosimf::soccer {

/// The pose of the robot after a time `dt` [s], in the frame of the pose before. `velocity` [m/s] forward, left;
/// `turned` [rad]. The way is an arc of a circle.
[[nodiscard]] inline Vec3d step_along(const Vec3d& velocity, double turned, double dt) noexcept {
  MUROSIMF_ASSERT(dt >= 0);
  const Vec3d way = from_frame({0, 0, 0.5 * turned}, {dt * velocity.x, dt * velocity.y, 0});  // along the chord
  return {way.x, way.y, turned};
}

}  // namespace murosimf::soccer
