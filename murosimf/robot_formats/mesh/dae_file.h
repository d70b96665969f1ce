/// dae_file.h - triangles of a COLLADA file, the format in which many URDF files have their meshes.
///
/// Read are the geometries of the scene with the transformations of their nodes, and the unit of length. The axis that is
/// "up" is not: a URDF file's origin expects the numbers as they are written (but see robot/mesh_up_axis.h). Skins, splines, materials and lights are not
/// read. Source: COLLADA - Digital Asset Schema Release 1.4.1, specification.
#pragma once

#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// Vertices as in the file, each as often as its geometry stands in the scene; a part for every geometry in the scene. Throws SetupError.
[[nodiscard]] MeshFile read_dae(const std::filesystem::path& file);

/// Whether the file says that its y axis is up, as files do that say nothing. Throws SetupError if it cannot be read.
[[nodiscard]] bool has_y_up(const std::filesystem::path& file);

}  // namespace murosimf::robot_formats::mesh
