/// ros_markers.h - foxglove.SceneUpdate as visualization_msgs/MarkerArray: one marker for each primitive, in the namespace of its entity.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "murosimf/recording/robot_urdf.h"

namespace murosimf::recording {

/// CDR. `shown`: how many markers each namespace has, before and after this message; those beyond are deleted. Models (meshes in files)
/// are left out. `names`: of frames. Throws SetupError: the message is damaged.
[[nodiscard]] std::string ros_markers(std::string_view scene_update, std::map<std::string, int>& shown,
                                      const FrameNames& names = {});

}  // namespace murosimf::recording
