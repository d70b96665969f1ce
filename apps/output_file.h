/// output_file.h - results go to files that are whole or not there at all.
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::app {

/// Throws SetupError if a file of this name could not be created now.
void check_writable(const std::filesystem::path& file);

/// Writes beside the file and renames, so that a full disk never leaves half of it. Throws SetupError.
void write_file(const std::filesystem::path& file, const std::string& text);

/// Throws SetupError if standard output is closed or full.
void write_standard_output(const std::string& text);

}  // namespace murosimf::app
