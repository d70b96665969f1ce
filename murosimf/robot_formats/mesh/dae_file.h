/// dae_file.h - triangles of a COLLADA file, a frequent format of meshes of URDF files.
///
/// Reads the geometries of the scene with the transformations of their nodes, and the unit of length. The "up" axis is
/// ignored: a URDF file's origin expects the numbers as they are written (but see robot/mesh_up_axis.h). Materials have colors
/// (dae_material.h); skins, splines, textures and lights are not read. Source: COLLADA - Digital Asset Schema Release 1.4.1, specification.
#pragma once

#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// Vertices as in the file, once for each use of their geometry in the scene; a part for every geometry in the scene. Throws SetupError.
[[nodiscard]] MeshFile read_dae(const std::filesystem::path& file);

/// Whether the y axis of the file is up, which is the default of the format. Throws SetupError if it cannot be read.
[[nodiscard]] bool has_y_up(const std::filesystem::path& file);

}  // namespace murosimf::robot_formats::mesh
