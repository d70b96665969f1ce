/// robot_feet.h - bodies that bear a robot's weight.
#pragma once

#include <cstddef>
#include <vector>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Bodies on which the robot stands in the pose of the file, in the order of the file: their colliding shapes extend to within
/// 1 cm of the lowest of all, they are behind at least two joints, all behind equally many, and are neither wheels nor
/// hands. Toes as low as that are parts of the foot that carries them. None if the robot stands on other bodies as well, or if its
/// center of mass is not above them.
[[nodiscard]] std::vector<std::size_t> find_feet(const robot_formats::RobotDescription& description);

}  // namespace murosimf::robot
