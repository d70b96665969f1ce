/// xacro_file.h - URDF files with macros, expanded by the program xacro (`pip install xacro`), as a process and never through a shell.
///
/// `$(find package)` is resolved by package_folders.h: the program is started again for each missing package. Numbers of lines in
/// messages are those of the expanded file.
#pragma once

#include <filesystem>
#include <string>

#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::urdf {

/// The expanded text. Throws SetupError, one line: there is no python3 or no xacro, a package is not found, what xacro complains of; and
/// where reads are limited (files/file_access.h), since macros name files and a program is started.
[[nodiscard]] std::string expand_xacro(const std::filesystem::path& file, const robot_formats::ReaderOptions& options);

/// Throws SetupError as expand_xacro and read_urdf.
[[nodiscard]] robot_formats::RobotDescription read_xacro(const std::filesystem::path& file,
                                                         const robot_formats::ReaderOptions& options = {});

}  // namespace murosimf::robot_formats::urdf
