/// frame_completion.h - poses of robots between two steps, after somebody has changed where they are or how they stand.
///
/// Columns have the poses of links as the last step left them; a level takes a change of its base or joints over in its next step
/// (model/column_view.h). Whoever looks on while a simulation is paused is to see it at once.
#pragma once

#include "murosimf/runtime/pose_frame.h"

namespace murosimf::scene {

/// Works out the poses of all links from those of the bases and the joint positions (multibody/kinematics.h).
void work_out_poses(const World& world, PoseFrame& frame);

}  // namespace murosimf::scene
