/// toml_bounds.h - refuses TOML of extreme depth before the library parses it, which recurses once per part of a
/// key and once per bracket and would overflow the stack.
#pragma once

#include <string_view>

namespace murosimf::files {

constexpr int most_key_parts = 32;      ///< a.b.c has 3
constexpr int most_open_brackets = 64;  ///< arrays and tables inside each other

/// `where`: the name of the file, or the --set that the text came from. Throws SetupError with line and column.
void check_toml_bounds(std::string_view text, std::string_view where);

}  // namespace murosimf::files
