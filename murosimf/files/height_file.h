/// height_file.h - tables of heights: gray pictures (PNG), arrays of numpy (NPY) and lists of numbers (CSV).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace murosimf::files {

constexpr std::size_t most_heights = 100'000;  ///< of one table: a surface of 200,000 triangles

struct HeightTable {
  std::size_t rows = 0, columns = 0;  ///< at least two each
  std::vector<double> heights;  ///< [1] of a picture: 0 is black, 1 is white; else the numbers of the file; row by row
  bool is_picture = false;
};

/// Reads a file of a kind by its extension, .png, .npy or .csv in small or capital letters. Throws SetupError, one line: file, line if
/// there is one, what is wrong, what to do. All heights are finite.
[[nodiscard]] HeightTable read_height_file(const std::filesystem::path& file);

/// Throws SetupError that begins with `file`: fewer than two rows or columns, more than most_heights, a number that is not finite.
void check_heights(std::string_view file, const HeightTable& table);

}  // namespace murosimf::files
