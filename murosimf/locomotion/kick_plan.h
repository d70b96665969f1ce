/// kick_plan.h - selects the kick of a robot that sends a ball in a direction, and the walk to where it kicks.
///
/// A kick of a ball that lies at k and goes in direction d, both seen from the robot, sends a ball at b in direction a from
///     heading  h = a - d        place  b - Rz(h) k
/// where b is not known, from where the robot stands, turned by h. Of all kicks, the one with the least
///     (sqrt((x/vx)^2 + (y/vy)^2) + |h|/wz) (1 + 2 |sin d|)          vx, vy, wz: the fastest walk
/// the time that the way takes, three times for a kick to the side, which needs the ball more exactly than the odometry of the way provides
/// (docs/motions.md, "Kicks in a direction").
#pragma once

#include <optional>
#include <vector>

#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/locomotion/motion_state.h"

namespace murosimf::locomotion {

struct KickChoice {
  int motion = 0;  ///< number among the robot's motions
  Kick kick;
};

struct KickPlan {
  int motion = 0;
  Vec3d place;  ///< [m, m, rad] where the robot stands to kick, seen from where it stands now
};

/// Nothing if the robot has no kick with the requested side. `fastest` [m/s, m/s, rad/s].
[[nodiscard]] std::optional<KickPlan> plan_kick(const std::vector<KickChoice>& kicks, const KickRequest& request,
                                                const Vec3d& fastest) noexcept;

/// [m, m, rad] a place seen from another one, both in the same frame.
[[nodiscard]] Vec3d seen_from(const Vec3d& place, const Vec3d& goal) noexcept;
/// The inverse: a place that is seen at `goal` from `place`.
[[nodiscard]] Vec3d from_there(const Vec3d& place, const Vec3d& goal) noexcept;

/// [m/s, m/s, rad/s] towards `goal` [m, m, rad]. The robot keeps at least `clearance` [m] from the `ball` [m] (0: there is no ball) and
/// walks around it where necessary. All seen from the robot.
[[nodiscard]] Vec3d velocity_to_kick(const Vec3d& goal, const Vec3d& ball, double clearance,
                                     const Vec3d& fastest) noexcept;

}  // namespace murosimf::locomotion
