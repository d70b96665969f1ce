/// robot_feet.h - which bodies of a robot bear its weight.
#pragma once

#include <cstddef>
#include <vector>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Bodies that the robot stands on in the pose of the file, in the order of the file: their colliding shapes reach down to
/// 1 cm above the lowest of all, they are behind two joints at least, each behind as many, and are neither wheels nor
/// hands. Toes that reach down as far belong to the foot that they hang on. None if the robot stands on something else, too, or if its center of mass is not above them.
[[nodiscard]] std::vector<std::size_t> find_feet(const robot_formats::RobotDescription& description);

}  // namespace murosimf::robot
