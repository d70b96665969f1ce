/// lump_fixed_joints.h - bodies without joints become parts of the body to which they are fixed.
///
/// Masses are combined by the parallel-axis theorem, shapes and frames are moved, and the body's own frame remains as a named
/// one. A body with a sensor of forces at its weld remains: contacts with it must be distinguished. So frames that many files have
/// as massless bodies or fixed links cost nothing in the simulation.
#pragma once

#include <set>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// `measured`: names of bodies that remain (sensor_cuts.h).
void lump_fixed_joints(robot_formats::RobotDescription& description, const std::set<std::string>& measured);

}  // namespace murosimf::robot
