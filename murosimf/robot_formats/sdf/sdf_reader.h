/// sdf_reader.h - a robot from an SDF file, the format of Gazebo.
///
/// Every link becomes a body in its own frame; links at fixed joints are bodies without joints. Joints that close loops become loops: balls
/// as `connect`, fixed ones as `weld`, hinges as two `connect` along their axis. A model that a joint holds in the world is bolted to it,
/// as is a static one. The model's own place is ignored: the scene places robots. Parts of a robot touch each other only with `self_collide`.
/// Servos are not made here: `limit` gives a joint's largest effort and rate. Parts without effect become notes; unknown words that look
/// like misspellings, or would change the robot, are errors. Frames are resolved by libsdformat (sdf_poses.h).
/// Source: SDFormat specification.
#pragma once

#include <filesystem>

#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::sdf {

/// Throws SetupError: file, line, what is wrong, what to do; also if this build has no libsdformat.
[[nodiscard]] robot_formats::RobotDescription read_sdf(const std::filesystem::path& file,
                                                       const robot_formats::ReaderOptions& options = {});

}  // namespace murosimf::robot_formats::sdf
