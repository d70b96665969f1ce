/// toml_bounds.h - refuses TOML that no person writes before the library sees it, which goes down one call per part of a
/// key and one per bracket and would end where the stack does.
#pragma once

#include <string_view>

namespace murosimf::files {

constexpr int most_key_parts = 32;      ///< a.b.c has 3
constexpr int most_open_brackets = 64;  ///< arrays and tables inside each other

/// `where`: the name of the file, or the --set it came from. Throws SetupError with line and column.
void check_toml_bounds(std::string_view text, std::string_view where);

}  // namespace murosimf::files
