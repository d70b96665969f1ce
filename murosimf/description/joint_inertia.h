/// joint_inertia.h - what a joint of a description has to move.
#pragma once

#include "murosimf/description/robot_description.h"

namespace murosimf::description {

/// [kg m^2 | kg] of everything behind a joint of `body`, in the pose of the file, and of its rotor: the diagonal of the
/// joint-space inertia matrix.
[[nodiscard]] double reflected_inertia(const RobotDescription& description, std::size_t body,
                                       const JointDescription& joint);

/// Position servos with a damping ratio z get velocity_gain = 2 z sqrt(position_gain * reflected inertia).
/// Source: MuJoCo documentation, XML reference, "position", attribute dampratio.
void resolve_damping_ratios(RobotDescription& description);

}  // namespace murosimf::description
