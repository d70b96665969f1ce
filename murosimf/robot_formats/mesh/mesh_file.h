/// mesh_file.h - triangle meshes from STL, OBJ and COLLADA files, and MuJoCo's own.
///
/// Own readers, since users need file and line of errors in a mesh.
/// STL: binary and ASCII, several solids count as one. Distinguished by size and content, because many binary files begin
/// with "solid", too. Normals and attribute bytes are ignored.
/// OBJ: v, vt and f lines, polygons as fans, names of materials (usemtl); normals, lines and curves are ignored.
/// COLLADA: geometries of the scene (dae_file.h).
/// MSH: MuJoCo's binary format (msh_file.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/geometry/triangle_mesh.h"
#include "murosimf/model/shape.h"

namespace murosimf::robot_formats::mesh {

/// Larger meshes are refused before they are read: the detail has no effect on contact or inertia.
constexpr std::size_t most_triangles = 1'000'000;

/// The message for such a mesh; with the number of its triangles if that is known before they are read.
[[nodiscard]] std::string too_many(std::size_t count = 0);

/// A material of a mesh file, for the eye.
struct MeshMaterial {
  std::string name;
  std::optional<Color> color{};  ///< nothing: unknown; of OBJ files only after add_mtl_colors (mtl_file.h)
  std::string picture{};         ///< file of the picture that colors it, as the mesh's file spells it; empty: none
};

using geometry::PicturePlaces;  ///< of a triangle in the picture of its material

struct MeshFile {
  geometry::TriangleMesh mesh;          ///< everything; corners at the same place are one vertex
  std::vector<std::size_t> part_begin;  ///< first triangle of each object, group or geometry that has triangles
  std::vector<MeshMaterial> materials{};
  std::vector<std::uint32_t> material_of{};  ///< by triangle, as far as it goes: 0, none, or 1 and more of `materials`
  std::vector<PicturePlaces> picture_places{};  ///< by triangle, as far as it goes, of files that have some
};

/// Reads a file of a kind by its extension, .stl, .obj, .dae or .msh in small or capital letters. Throws SetupError, one line: file, line
/// if there is one, what is wrong, what to do. Guarantees finite numbers and valid indices; the surface need not be closed.
[[nodiscard]] MeshFile read_mesh_file(const std::filesystem::path& file);

/// The parts of a file, each with its own vertices; one if the file has no objects or groups.
[[nodiscard]] std::vector<geometry::TriangleMesh> split_parts(const MeshFile& file);

}  // namespace murosimf::robot_formats::mesh
