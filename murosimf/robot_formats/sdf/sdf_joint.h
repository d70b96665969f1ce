/// sdf_joint.h - joints of an SDF file.
///
/// `universal` and `revolute2` become two hinges NAME.1 and NAME.2, `ball` three, NAME.x, .y and .z, as in MJCF. A joint with equal
/// limits is fixed there. A limit that is infinite, or beyond 1e15, is none. Source: SDFormat specification, "joint".
#pragma once

#include <vector>

#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/sdf/sdf_parts.h"
#include "murosimf/robot_formats/sdf/sdf_poses.h"

namespace murosimf::robot_formats::sdf {

/// Whether joints of a type are supported; others are refused. fixed, revolute, continuous, prismatic, ball, universal, revolute2.
[[nodiscard]] bool is_known_type(const std::string& type);

/// Place of a joint.
struct SdfJointSpot {
  Transformd body;        ///< frame of the body that it moves, in the frame of the model
  bool reversed = false;  ///< that body is the joint's parent
};

/// The joints that move a body: none of a fixed joint. A joint that its limits hold at an angle or a distance other than 0 moves `spot.body`.
[[nodiscard]] std::vector<robot_formats::JointDescription> read_joints(const SdfPart& joint, const SdfJointPose& pose,
                                                                       SdfJointSpot& spot, urdf::UrdfLog& log);

/// Reads `mimic` of the axes of all joints that are among the bodies' joints. Throws SetupError for a circle.
void read_mimics(const std::vector<SdfPart>& joints, robot_formats::RobotDescription& description, urdf::UrdfLog& log);

}  // namespace murosimf::robot_formats::sdf
