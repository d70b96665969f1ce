/// mesh_file.h - triangle meshes from STL, OBJ and COLLADA files, and MuJoCo's own.
///
/// Our own small readers, because users need file and line of what is wrong with a mesh.
/// STL: binary and ASCII, several solids count as one. Told apart by size and content, because many binary files begin
/// with "solid", too. Normals and attribute bytes are ignored.
/// OBJ: v and f lines, polygons as fans; normals, textures, materials, lines and curves are ignored.
/// COLLADA: geometries of the scene (dae_file.h).
/// MSH: MuJoCo's binary format (msh_file.h).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/geometry/triangle_mesh.h"

namespace murosimf::robot_formats::mesh {

/// More is refused before it is read: such a mesh has nothing that a contact or an inertia could use.
constexpr std::size_t most_triangles = 1'000'000;

/// What the readers say of such a mesh; with the number of its triangles if that is known before they are read.
[[nodiscard]] std::string too_many(std::size_t count = 0);

struct MeshFile {
  geometry::TriangleMesh mesh;          ///< everything; corners at the same place are one vertex
  std::vector<std::size_t> part_begin;  ///< first triangle of each object, group or geometry that has triangles
};

/// The kind of file goes by its extension, .stl, .obj, .dae or .msh in any case. Throws SetupError, one line: file, line if there is
/// one, what is wrong, what to do. Finite numbers and valid indices are sure; that the surface closes is not.
[[nodiscard]] MeshFile read_mesh_file(const std::filesystem::path& file);

/// The parts of a file, each with its own vertices; one if the file has no objects or groups.
[[nodiscard]] std::vector<geometry::TriangleMesh> split_parts(const MeshFile& file);

}  // namespace murosimf::robot_formats::mesh
