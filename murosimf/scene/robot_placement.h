/// robot_placement.h - puts a robot, ball or body somewhere else while the scene runs, as people do in a game: upright, at
/// rest, joints as they are.
///
/// Its level begins there; its software, sensors and the clock go on and do not notice more than a real robot would.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

using scene_file::Placement;

/// Between two steps: a robot, the ball or a body that moves. The first sole is flat, or, without soles, the base level. Throws
/// SetupError for unknown entities, for those that are not there or frozen, and if the level cannot begin so.
void place(SceneParts& parts, std::string_view entity, const Placement& placement);

}  // namespace murosimf::scene
