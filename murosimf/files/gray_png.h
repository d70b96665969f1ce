/// gray_png.h - gray pictures of 8 or 16 bits as tables of heights.
///
/// Source: W3C, "Portable Network Graphics (PNG) Specification (Second Edition)", 2003: chunks (5), filters (9). A reader of its own,
/// since that of cairo drops half of the 16 bits.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "murosimf/files/height_file.h"

namespace murosimf::files {

/// Reads the bytes of a file. Throws SetupError that begins with `name`: no PNG, in color, of another depth, interlaced, broken; and if the
/// program was built without zlib.
[[nodiscard]] HeightTable png_heights(const std::string& name, const std::string& bytes);

/// Unpacks bytes of zlib; nothing if they are broken, or if they are not `size` bytes. Throws SetupError without zlib.
[[nodiscard]] std::optional<std::string> inflated(std::string_view packed, std::size_t size);

}  // namespace murosimf::files
