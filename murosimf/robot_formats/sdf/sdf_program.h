/// sdf_program.h - finds the program that calls libsdformat.
#pragma once

#include <filesystem>

namespace murosimf::robot_formats::sdf {

/// `murosimf-sdf-frames` beside the running program, where it was built, or where it is installed. `file` begins the message. Throws
/// SetupError if this build has no libsdformat, or the program is in none of these places.
[[nodiscard]] std::filesystem::path sdf_program(const std::filesystem::path& file);

/// Whether this build has libsdformat.
[[nodiscard]] bool has_sdf_program();

}  // namespace murosimf::robot_formats::sdf
