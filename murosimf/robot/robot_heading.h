/// robot_heading.h - turns the base of a robot on two soles that does not face x in its file.
///
/// x of the base is forward everywhere in the library. In some files (iCub) the leg that is called left is to the right of the other: such
/// a robot faces another direction. Its base is turned about z by quarters of a turn until x is forward, with all parts of the base.
#pragma once

#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// To be called when soles are known, and before they are placed. Sides are those of the names of the feet (body_names.h); the axis from
/// right to left is that of the hips. If feet would point backward then, nothing changes, with a warning. Soles of the file are turned
/// so that their x is forward as well.
void face_forward(robot_formats::RobotDescription& description, const RobotConfig& table);

}  // namespace murosimf::robot
