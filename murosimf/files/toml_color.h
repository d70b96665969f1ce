/// toml_color.h - colors in scene files: three numbers from 0 to 1.
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include "murosimf/files/toml_reader.h"
#include "murosimf/model/shape.h"

namespace murosimf::files {

/// The key 'color' of a table: red, green, blue; `otherwise` if there is none. Throws SetupError with its place.
[[nodiscard]] Color read_color(const TomlTable& table, const Color& otherwise);

}  // namespace murosimf::files
