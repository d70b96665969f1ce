/// mesh_up_axis.h - meshes of files that were written for programs that turn COLLADA's `Y_UP` to z.
///
/// ROS, and most programs that read URDF, take the numbers of a COLLADA file as they are, whatever it says is up, and so do we. Some files were
/// written for programs that turn such meshes by a quarter about x: their feet stand across, both to one side. What the file means shows
/// the symmetry of the robot: a pair of left and right shapes is plainly no mirror image where the middle of one, mirrored, is more than 1 cm from
/// that of the other. If meshes with y up, turned, leave at most a quarter of such pairs, the file means that.
#pragma once

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Turns all such meshes of the robot, for contact and for the eye, with a note, or none. Scales that differ by direction are left alone.
/// Left and right are known by names (body_names.h).
void turn_meshes_up(robot_formats::RobotDescription& description);

}  // namespace murosimf::robot
