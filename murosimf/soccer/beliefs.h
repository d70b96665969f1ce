/// beliefs.h - pose estimates of robots, drawn for observers as ghosts beside the true poses.
#pragma once

#include <optional>

#include "murosimf/world/entity.h"

namespace murosimf::soccer {

/// [m, m, rad] x, y and heading of its base on the field, as estimated by the robot's own software (properties::pose_estimate); nothing if
/// there is no estimate, or the robot is absent.
[[nodiscard]] std::optional<Vec3d> believed_pose(const Entity& robot);

}  // namespace murosimf::soccer
