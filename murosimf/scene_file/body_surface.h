/// body_surface.h - [[bodies]] with a shape from a table of heights or a mesh.
///
/// For .cpp files only: it includes toml++.
#pragma once

#include <filesystem>

#include "murosimf/files/toml_reader.h"
#include "murosimf/scene_file/body_spec.h"

namespace murosimf::scene_file {

/// Files are also searched in `folder`, that of the scene. Both throw SetupError with file:line:column, and the error of the file.
void read_height_field(const files::TomlTable& table, const std::filesystem::path& folder, BodySpec& body);
/// A static mesh becomes ground of its triangles, a moving one its convex hull.
void read_mesh(const files::TomlTable& table, const std::filesystem::path& folder, BodySpec& body);

}  // namespace murosimf::scene_file
