/// robot_placement.h - puts a robot somewhere else while the scene runs, as people do in a game: upright, at rest, joints as they are.
///
/// Its level begins there; its software, sensors and the clock go on and do not notice more than a real robot would.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

/// Where a robot is put.
struct Placement {
  Vec3d position;      ///< [m] of the base on the ground plane; z: of its lowest point
  double heading = 0;  ///< [rad] about the vertical
};

/// Between two steps. The first sole is flat, or, without soles, the base level. Throws SetupError for unknown robots, for those that are
/// not there or frozen, and if the level cannot begin so.
void place(SceneParts& parts, std::string_view robot, const Placement& placement);

}  // namespace murosimf::scene
