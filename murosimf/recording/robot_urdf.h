/// robot_urdf.h - a robot of a scene as URDF, for programs that know no other format: the links and joints of its file.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "murosimf/scene/scene.h"

namespace murosimf::recording {

/// From the robot's file, which is read again; meshes are named relative to it. Empty for what is no robot of the scene. Throws SetupError: the
/// file is not there any more, or URDF cannot say what it contains.
[[nodiscard]] std::string urdf_of(const scene::Scene& scene, const Entity& robot);

/// New names of frames by the old ones; those that are not in it keep theirs.
using FrameNames = std::map<std::string, std::string, std::less<>>;

/// Frames of a recording have the name of the joint above a link, "blue1/left_knee": by these the name of the link itself, as programs expect that
/// read such a description.
[[nodiscard]] FrameNames frames_by_links(const std::string& robot, std::string_view urdf);

}  // namespace murosimf::recording
