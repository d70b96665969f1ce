/// joint_inertia.h - inertia that a joint of a description moves.
#pragma once

#include <vector>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats {

/// [kg m^2 | kg] of everything behind a joint of `body`, in the pose of the file, and of its rotor: the diagonal of the
/// joint-space inertia matrix.
[[nodiscard]] double reflected_inertia(const RobotDescription& description, std::size_t body,
                                       const JointDescription& joint);

/// [kg m^2 | kg] Inertia that each joint moves while the others and the base are free, unless that is fixed: 1 / (M^-1)_ii of the
/// joint-space inertia matrix M in the pose of the file; joints in the order of bodies. Empty if a joint moves no inertia.
[[nodiscard]] std::vector<double> free_inertias(const RobotDescription& description);

/// Sets velocity_gain = 2 z sqrt(position_gain * reflected inertia) of position servos with a damping ratio z.
/// Source: MuJoCo documentation, XML reference, "position", attribute dampratio.
void resolve_damping_ratios(RobotDescription& description);

}  // namespace murosimf::robot_formats
