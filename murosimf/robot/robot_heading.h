/// robot_heading.h - which way a robot on two soles faces, where its file does not have it facing x.
///
/// Everything here takes x of the base for forward. In some files (iCub) the leg that is called left is to the right of the other: such a
/// robot faces another way. Its base is turned about z by quarters of a turn until x is forward, with all that the base has.
#pragma once

#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// To be called when soles are known, and before they are placed. Sides are those that names of the feet say (body_names.h); the axis from
/// right to left is that of the hips. Nothing changes, with a warning, if feet would point backward then. Soles that the file has are turned
/// so that their x is forward, too.
void face_forward(robot_formats::RobotDescription& description, const RobotConfig& table);

}  // namespace murosimf::robot
