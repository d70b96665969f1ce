/// body_surface.h - [[bodies]] whose shape comes from a table of heights or a mesh.
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <filesystem>

#include "murosimf/files/toml_reader.h"
#include "murosimf/scene_file/body_spec.h"

namespace murosimf::scene_file {

/// Files are also looked for in `folder`, that of the scene. Both throw SetupError with file:line:column, and what is wrong with a file.
void read_height_field(const files::TomlTable& table, const std::filesystem::path& folder, BodySpec& body);
/// A static one is the ground that its triangles are, another one their convex hull.
void read_mesh(const files::TomlTable& table, const std::filesystem::path& folder, BodySpec& body);

}  // namespace murosimf::scene_file
