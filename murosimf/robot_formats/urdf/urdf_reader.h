/// urdf_reader.h - a robot from a URDF file.
///
/// Every link becomes a body in the frame of the joint above it; links at fixed joints are bodies without joints. The
/// root is the base. An empty link above a floating joint is the world and omitted, and so is the robot's place in it:
/// the scene places robots. Servos are not made here: `limit` gives a joint's largest effort and rate. Read besides:
/// `mimic`, gazebo blocks as described in urdf_gazebo.h, the compiler options meshdir, strippath and balanceinertia of a
/// `mujoco` block. Parts without effect on a robot's model (plugins, transmissions, textures) and unknown parts are notes;
/// misspellings and parts that would change the motion are errors. Masses are used as
/// written (robot/repair_solids.h repairs those that could not be simulated).
/// Source: URDF XML specification.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::urdf {

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] robot_formats::RobotDescription read_urdf(const std::filesystem::path& file,
                                                        const robot_formats::ReaderOptions& options = {});
/// The same for a text that replaces the file (xacro_file.h): names in it are relative to the file's folder.
[[nodiscard]] robot_formats::RobotDescription read_urdf_text(const std::filesystem::path& file, const std::string& text,
                                                             const robot_formats::ReaderOptions& options);

}  // namespace murosimf::robot_formats::urdf
