#include "murosimf/soccer/beliefs.h"

#include <cmath>

#include "murosimf/soccer/behavior_properties.h"

namespace murosimf::soccer {

std::optional<Vec3d> believed_pose(const Entity& robot) {
  const Column<Vec3d>* column = robot.find(properties::pose_estimate);
  if (!column || column->values.empty() || !robot.present()) return std::nullopt;
  const Vec3d& pose = column->values[0];
  if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.z)) return std::nullopt;
  return pose;
}

}  // namespace murosimf::soccer
