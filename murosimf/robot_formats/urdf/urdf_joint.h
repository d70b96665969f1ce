/// urdf_joint.h - joints of a URDF file: kind, axis, range, dynamics, and which joint follows which.
#pragma once

#include <vector>

#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/urdf/urdf_tree.h"

namespace murosimf::robot_formats::urdf {

/// A moving joint. Its frame is that of the link below it. Throws SetupError: no axis direction, no limits where
/// the type needs them, impossible numbers.
[[nodiscard]] robot_formats::JointDescription read_joint(const UrdfJoint& joint, UrdfLog& log);

/// Place of the link below a joint in the link above it, with the joint at 0 or where its limits hold it.
[[nodiscard]] Transformd read_place(const UrdfJoint& joint);

/// Reads all `mimic` elements of moving joints; without its leader one is left out, with a warning. Throws SetupError: fixed
/// leader, circles.
[[nodiscard]] std::vector<robot_formats::MimicDescription> read_mimics(const UrdfTree& tree, UrdfLog& log);

}  // namespace murosimf::robot_formats::urdf
