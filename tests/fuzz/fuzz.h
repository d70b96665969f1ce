/// fuzz.h - what the fuzz targets share: bytes become a file, and a reader may refuse it with a SetupError, nothing else.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "murosimf/model/error.h"

namespace murosimf::fuzz {

/// A file of this process in the folder for temporary files (TMPDIR; one in memory is faster).
inline std::filesystem::path scratch_file(const std::string& extension) {
  return std::filesystem::temp_directory_path() / ("murosimf_fuzz_" + std::to_string(getpid()) + extension);
}

/// Calls read(file) for a file with these bytes. A refusal must say something.
template <class Read>
void feed(const std::uint8_t* data, std::size_t size, const std::string& extension, const Read& read) {
  const std::filesystem::path file = scratch_file(extension);
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    read(file);
  } catch (const SetupError& error) {
    if (*error.what() == '\0') std::abort();
  }
}

}  // namespace murosimf::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
