/// obj_file.h - triangles of an OBJ file.
#pragma once

#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// Vertices as in the file. Throws SetupError.
[[nodiscard]] MeshFile read_obj(const std::filesystem::path& file);

}  // namespace murosimf::robot_formats::mesh
