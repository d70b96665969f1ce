/// robot_builder.h - a description becomes a Model: a tree of the seven basic objects.
///
/// A body becomes translation (`<body>.offset`), rotation (`<body>.turn`) and its joints; what is the identity is left
/// out. A joint away from the body's origin has a translation before (`<joint>.anchor`) and its inverse behind; one whose
/// position is not zero in the pose of the file has a turn or shift back before (`<joint>.zero`). The last of these
/// objects has the body's frame and carries its mass, shapes and visual meshes; it has the body's name, as an alias if it is a joint.
/// Child bodies and frames follow as branches of a fork; a frame ends in an endpoint of its name.
/// In a Model no two objects share a name: a joint keeps it, a body or frame of the same name gets a suffix.
#pragma once

#include "murosimf/model/model.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Takes servos, soles and surfaces of the table, which win over those of the file. Bodies without joints should be
/// welded and soles placed before (lump_fixed_joints.h, role_inference.h). Renamed and massless bodies are lines in the description's warnings.
/// Throws SetupError, with the place in the file, for what Model refuses.
[[nodiscard]] ModelPtr build_model(robot_formats::RobotDescription& description, const RobotConfig& table);

}  // namespace murosimf::robot
