/// stl_file.h - triangles of an STL file.
#pragma once

#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// Three separate vertices for every triangle. `size` of the file [byte], not zero. Throws SetupError.
[[nodiscard]] MeshFile read_stl(const std::filesystem::path& file, std::size_t size);

}  // namespace murosimf::robot_formats::mesh
