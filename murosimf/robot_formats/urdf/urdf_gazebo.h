/// urdf_gazebo.h - reads the `gazebo` blocks of a URDF file for links and joints.
///
/// Read are friction (mu1, or mu of the surface of a collision; where mu2 differs: a warning), springs at joints, and sensors; other changes
/// of the robot are refused; plugins, appearance and solver settings are notes.
/// Source: SDFormat documentation, "URDF in Gazebo".
#pragma once

#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/urdf/urdf_log.h"
#include "murosimf/robot_formats/urdf/urdf_tree.h"

namespace murosimf::robot_formats::urdf {

/// `description` has the bodies of all links.
void read_gazebo(const files::XmlElement& robot, const UrdfTree& tree, robot_formats::RobotDescription& description,
                 UrdfLog& log);

}  // namespace murosimf::robot_formats::urdf
