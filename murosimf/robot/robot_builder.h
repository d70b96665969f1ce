/// robot_builder.h - makes a Model, a tree of the seven basic objects, from a description.
///
/// A body becomes translation (`<body>.offset`), rotation (`<body>.turn`) and its joints; identities are left
/// out. A joint away from the body's origin has a translation before it (`<joint>.anchor`) and the inverse after it; one with a
/// position other than zero in the pose of the file has the inverse motion before it (`<joint>.zero`). The last of these
/// objects has the body's frame, mass, shapes and visual meshes, and the body's name, as an alias if it is a joint.
/// Child bodies and frames follow as branches of a fork; a frame ends in an endpoint of its name.
/// In a Model no two objects share a name: a joint keeps it, a body or frame of the same name gets a suffix.
#pragma once

#include "murosimf/model/model.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Uses servos, soles and surfaces of the table, which replace those of the file. Bodies without joints should be
/// welded and soles placed before (lump_fixed_joints.h, role_inference.h). Renamed and massless bodies are lines in the description's warnings.
/// Throws SetupError, with the place in the file, for a tree that Model refuses.
[[nodiscard]] ModelPtr build_model(robot_formats::RobotDescription& description, const RobotConfig& table);

}  // namespace murosimf::robot
