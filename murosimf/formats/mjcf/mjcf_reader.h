/// mjcf_reader.h - a robot from an MJCF file, the format of MuJoCo, as a description.
///
/// The robot is the body under worldbody that has a free joint. Read are bodies, joints, inertials, geoms, meshes, sites,
/// frames, cameras, actuators, sensors, default classes, includes, linear couplings of joints, contact masks, exclusions
/// and the compiler's settings. What means nothing to a robot's model (solver options, textures, the floor) is a note;
/// what is unknown or would change the motion is an error.
/// Source: XML reference of the MuJoCo documentation.
/// Limits: no ball joints, tendons, other equality constraints, replicate and attach.
#pragma once

#include "murosimf/description/reader_options.h"
#include "murosimf/description/robot_description.h"

namespace murosimf::formats::mjcf {

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] description::RobotDescription read_mjcf(const std::filesystem::path& file,
                                                      const description::ReaderOptions& options = {});

}  // namespace murosimf::formats::mjcf
