/// mjcf_mesh_source.h - the triangles of one `mesh` element of an MJCF file, in the mesh frame.
#pragma once

#include <filesystem>

#include "murosimf/robot_formats/mesh/mesh_file.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"

namespace murosimf::robot_formats::mjcf {

/// The name of a mesh: its own, or the stem of its file. Throws SetupError if it has neither.
[[nodiscard]] std::string mesh_name(const MjcfAttributes& attributes);

/// Triangles of the attributes `vertex` and `face`; without `face` those of the hull. Throws SetupError.
[[nodiscard]] robot_formats::mesh::MeshFile read_inline_mesh(const MjcfAttributes& attributes);

/// Applies refpos, refquat and scale. An odd number of negative scales reverses the triangles, so that the outside
/// remains outside. Throws SetupError for a scale of zero.
void place_mesh(geometry::TriangleMesh& mesh, const MjcfAttributes& attributes);

}  // namespace murosimf::robot_formats::mjcf
