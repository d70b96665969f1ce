/// mtl_file.h - colors and pictures of the materials that an OBJ file names, from the MTL files beside it.
///
/// Read are `Kd` (as sRGB, which exporters write), `d`, `Tr` and the file of `map_Kd`; its options and everything else are not. Source:
/// Alias Wavefront, "MTL material format".
#pragma once

#include <string>
#include <vector>

#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// Gives the materials of an OBJ file their colors and pictures; other files are left alone. Only files named *.mtl beside the OBJ file
/// are read. Returns lines about what is not shown: files that are missing or elsewhere, options of pictures. Throws nothing.
[[nodiscard]] std::vector<std::string> add_mtl_colors(const std::filesystem::path& file, MeshFile& mesh);

}  // namespace murosimf::robot_formats::mesh
