/// robot_visuals.h - the meshes for the eye that a robot file gives a body.
#pragma once

#include "murosimf/description/robot_draft.h"
#include "murosimf/model/visual_mesh.h"

namespace murosimf::description {

/// The meshes for the eye of a body of the draft, in the body's frame. Left out is what stands in the robot file itself.
[[nodiscard]] Visuals visuals_of(const RobotDraft& draft, const DraftBody& body);

}  // namespace murosimf::description
