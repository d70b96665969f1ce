/// urdf_reader.h - a robot from a URDF file.
///
/// Every link becomes a body in the frame of the joint above it; links at fixed joints are bodies without joints. The
/// root is the base. An empty link above a floating joint is the world and left out, and so is the robot's place in it:
/// the scene places robots. Servos are not made here: `limit` gives a joint's largest effort and rate. Read besides:
/// `mimic`, of gazebo blocks what urdf_gazebo.h says, the compiler options meshdir, strippath and balanceinertia of a
/// `mujoco` block. What means nothing to a robot's model (plugins, transmissions, textures) is a note; what is unknown
/// or would change the motion is an error.
/// Source: URDF XML specification.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "murosimf/io/robot_draft.h"

namespace murosimf::io {

struct UrdfOptions {
  bool lenient = false;  ///< what is unknown or not supported becomes a warning, where a robot remains without it
  std::map<std::string, std::filesystem::path> package_map{};  ///< folders of packages that mesh names speak of
  std::vector<std::filesystem::path> search_paths{};           ///< folders in which packages and meshes are looked for
};

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] RobotDraft read_urdf(const std::filesystem::path& file, const UrdfOptions& options = {});

}  // namespace murosimf::io
