/// lump_fixed_joints.h - bodies without joints become parts of the body that they are fixed to.
///
/// Masses are joined by the parallel-axis theorem, shapes and frames move over, and the body's own frame stays as a named
/// one. A body at whose weld a sensor measures forces stays: what touches it must be told apart. So the frames that many files have as massless bodies or fixed links cost nothing while a robot moves.
#pragma once

#include <set>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// `measured`: names of bodies that stay (sensor_cuts.h).
void lump_fixed_joints(robot_formats::RobotDescription& description, const std::set<std::string>& measured);

}  // namespace murosimf::robot
