/// output_file.h - results go to files that are whole or not there at all.
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::files {

/// Throws SetupError if a file of this name could not be created now: found out before a long run, not after it.
void check_writable(const std::filesystem::path& file);

/// Writes beside the file and renames, so that a full disk never leaves half of it and keeps what was there before.
/// Devices and pipes are written directly. Throws SetupError: cannot write 'file': reason.
void write_file(const std::filesystem::path& file, const std::string& bytes);

}  // namespace murosimf::files
