/// side_line.h - waiting places of penalized robots: beside the field, in their own half, facing it.
#pragma once

#include <vector>

#include "murosimf/math/vec3.h"
#include "murosimf/scene/robot_placement.h"
#include "murosimf/scene_file/field.h"

namespace murosimf::league {

/// Level with the penalty mark of the own half, outside of the touch line; if that place is taken, farther towards the half line or the goal
/// line. `attacks`: +1, the goal at positive x; -1, the other one. `side`: +1, the touch line at positive y; -1. `others` [m]: places of
/// the entities that may be there.
[[nodiscard]] scene::Placement place_at_side_line(const scene_file::FieldSize& field, double attacks, double side,
                                                  const std::vector<Vec3d>& others);

}  // namespace murosimf::league
