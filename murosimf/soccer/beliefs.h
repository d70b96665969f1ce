/// beliefs.h - where robots take themselves to be, for people who watch: ghosts beside the truth.
#pragma once

#include <optional>

#include "murosimf/model/entity.h"

namespace murosimf::soccer {

/// [m, m, rad] x, y and heading of its base on the field, as the robot's own software says (properties::pose_estimate); nothing if it has
/// no opinion, or is not there.
[[nodiscard]] std::optional<Vec3d> believed_pose(const Entity& robot);

}  // namespace murosimf::soccer
