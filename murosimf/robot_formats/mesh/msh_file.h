/// msh_file.h - triangle meshes in MuJoCo's own binary format of old models.
///
/// Four 32-bit counts (vertices, normals, texture coordinates, faces), then as many float triples, triples and pairs, then three 32-bit
/// corners for each face, all little-endian. Normals and texture coordinates are ignored.
/// Source: MuJoCo documentation, XML reference, "mesh", "MSH file format".
#pragma once

#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// `size`: of the file [byte]. Throws SetupError as read_mesh_file does.
[[nodiscard]] MeshFile read_msh(const std::filesystem::path& path, std::size_t size);

}  // namespace murosimf::robot_formats::mesh
