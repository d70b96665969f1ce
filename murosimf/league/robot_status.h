/// robot_status.h - status of a robot in a game: its estimated or true pose, the ball, and whether it has fallen.
#pragma once

#include "murosimf/league/game_state.h"
#include "murosimf/math/mat3.h"
#include "murosimf/math/vec3.h"

namespace murosimf::league {

/// Of a robot's base and the ball, world frame: centre of the field, x towards one goal, z up.
struct SeenRobot {
  Vec3d position;  ///< [m]
  Mat3d axes;      ///< of the base: x forward, y left, z up
  const Vec3d* estimate =
      nullptr;  ///< [m, m, rad] x, y and heading as estimated by its software; null: no estimate, so the truth
  const Vec3d* ball = nullptr;  ///< [m]; null: no ball
  double attacks = 1;           ///< +1: its team attacks the goal at positive x; -1: the other one
};

/// Numbers of team and player are left to the caller. The ball has its true place, and was just seen. Fallen is a robot with a base that leans more than
/// 60 degrees.
[[nodiscard]] RobotStatus status_of(const SeenRobot& robot) noexcept;

}  // namespace murosimf::league
