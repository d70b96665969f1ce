#include "murosimf/league/robot_status.h"

#include <cmath>
#include <numbers>

#include "murosimf/math/assert.h"

namespace murosimf::league {

RobotStatus status_of(const SeenRobot& robot) noexcept {
  MUROSIMF_ASSERT(robot.attacks == 1 || robot.attacks == -1);
  const double least_upright = 0.5;  // cosine of 60 degrees
  const double truth = std::atan2(robot.axes.x.y, robot.axes.x.x);
  const Vec3d pose = robot.estimate ? *robot.estimate : Vec3d{robot.position.x, robot.position.y, truth};
  RobotStatus status;
  // negated, so that NaN of a frozen robot counts as fallen
  status.fallen = !(robot.axes.z.z > least_upright);
  status.x = robot.attacks * pose.x;  // the other team's field is rotated by half a turn
  status.y = robot.attacks * pose.y;
  status.heading = std::remainder(pose.z + (robot.attacks < 0 ? std::numbers::pi : 0.0), 2 * std::numbers::pi);
  if (robot.ball) {
    const double x = robot.ball->x - robot.position.x, y = robot.ball->y - robot.position.y;
    status.ball_age = 0;
    status.ball_x = std::cos(truth) * x + std::sin(truth) * y;
    status.ball_y = -std::sin(truth) * x + std::cos(truth) * y;
  }
  return status;
}

}  // namespace murosimf::league
