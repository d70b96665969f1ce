/// robot_visuals.h - the visual meshes that a robot file gives a body.
#pragma once

#include "murosimf/model/visual_mesh.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats {

/// The visual meshes of a body of the description, in the body's frame, without those with vertices in the robot file itself.
[[nodiscard]] Visuals visuals_of(const RobotDescription& description, const BodyDescription& body);

}  // namespace murosimf::robot_formats
