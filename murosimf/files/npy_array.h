/// npy_array.h - reads tables of heights that numpy.save has written.
///
/// Source: NumPy, "NEP 1 - A simple file format for NumPy arrays": magic, version, length of the header, a Python literal, numbers.
#pragma once

#include <string>

#include "murosimf/files/height_file.h"

namespace murosimf::files {

/// Reads the bytes of a file: two dimensions, in the order of C, of integers of 8 or 16 bits or floats of 32 or 64 bits. Throws SetupError
/// that begins with `name`.
[[nodiscard]] HeightTable npy_heights(const std::string& name, const std::string& bytes);

}  // namespace murosimf::files
