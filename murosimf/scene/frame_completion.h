/// frame_completion.h - poses of robots between two steps, after a change of their pose or posture.
///
/// Columns have the poses of links of the last step; a level applies a change of its base or joints in its next step
/// (world/column_view.h). Observers of a paused simulation must see it at once.
#pragma once

#include "murosimf/runtime/pose_frame.h"

namespace murosimf::scene {

/// Computes the poses of all links from those of the bases and the joint positions (multibody/kinematics.h).
void work_out_poses(const World& world, PoseFrame& frame);

}  // namespace murosimf::scene
