/// robot_placement.h - moves a robot, ball or body to another place while the scene runs, as referees do in a game: upright, at
/// rest, joints unchanged.
///
/// Its level restarts there; its software, sensors and the clock continue and notice no more than on a real robot.
#pragma once

#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

using scene_file::Placement;

/// Between two steps: a robot, the ball or a moving body. The first sole is level, or, without soles, the base. Throws
/// SetupError for unknown entities, for absent or frozen ones, and if the level cannot start like this.
void place(SceneParts& parts, std::string_view entity, const Placement& placement);

}  // namespace murosimf::scene
