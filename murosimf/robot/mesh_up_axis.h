/// mesh_up_axis.h - meshes of files that were written for programs that turn COLLADA's `Y_UP` to z.
///
/// ROS, and most programs that read URDF, use the numbers of a COLLADA file unchanged, whatever its up axis, and so does this reader. Some
/// files were written for programs that turn such meshes by a quarter about x: here their feet would point to one side. The symmetry of the
/// robot shows which is right: a pair of left and right shapes is clearly no mirror image if the mirrored middle of one is more than 1 cm
/// from that of the other. If turned meshes leave at most a quarter of such pairs, the file was written for those programs.
#pragma once

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Turns all such meshes of the robot, for contact and for drawing, with a note; or none. Uneven scales are not turned.
/// Left and right are known by names (body_names.h).
void turn_meshes_up(robot_formats::RobotDescription& description);

}  // namespace murosimf::robot
