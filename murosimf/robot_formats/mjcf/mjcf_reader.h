/// mjcf_reader.h - a robot from an MJCF file, the format of MuJoCo, as a description.
///
/// The robot is a floating tree or everything that is bolted to the world (mjcf_trees.h). Read are bodies, joints, inertials, geoms, meshes,
/// sites, frames, cameras, actuators, sensors, default classes, includes, linear couplings of joints, fixed tendons, loops, contact masks,
/// exclusions and the compiler's settings. Parts without effect on a robot's model (solver options, textures, the floor) are notes; parts that would drive or
/// hold it and do not act (spatial tendons, muscles, equalities with other objects) are warnings; unknown parts, and those that would change masses,
/// joints or contacts, are errors.
/// Source: XML reference of the MuJoCo documentation.
/// Limits: a ball joint is three hinges; the ground of the file is left to the scene.
#pragma once

#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Throws SetupError: file, line, what is wrong, what to do.
[[nodiscard]] robot_formats::RobotDescription read_mjcf(const std::filesystem::path& file,
                                                        const robot_formats::ReaderOptions& options = {});

}  // namespace murosimf::robot_formats::mjcf
