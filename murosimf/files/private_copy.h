/// private_copy.h - a copy of a shared library that nobody else can write to, for the loader.
///
/// What is loaded is a map of its file: who writes into the file (cp, scp, rsync --inplace, a compiler) changes code that runs, and who
/// makes it shorter has it crash. So the file is read once, checked to be whole, and a copy of it is loaded.
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::files {

/// Exists as long as it is needed to load it. Stands beside the file, under a hidden name of its own, so that what the library looks
/// for by $ORIGIN or dladdr beside itself is found; in memory where that folder cannot be written to.
class PrivateCopy {
 public:
  /// Throws SetupError in one line that begins with `shown`: the file cannot be read, is no shared library, or is not whole.
  PrivateCopy(const std::filesystem::path& file, const std::string& shown);
  ~PrivateCopy();
  PrivateCopy(const PrivateCopy&) = delete;
  PrivateCopy& operator=(const PrivateCopy&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  [[nodiscard]] bool write_beside(const std::filesystem::path& file, const std::string& bytes);
  [[nodiscard]] bool write_to_memory(const std::string& bytes);

  std::filesystem::path path_;
  int descriptor_ = -1;
  bool beside_ = false;
};

/// The bytes of the file. Throws SetupError.
[[nodiscard]] std::string read_library(const std::filesystem::path& file);

/// Whether these bytes are all of an ELF file: its segments and sections end within it. Files that are being written are not. What is
/// no ELF file at all is whole: the loader says what is wrong with it.
[[nodiscard]] bool is_whole_library(const std::string& bytes);

/// Whether another program has the file open for writing. False where that cannot be known.
[[nodiscard]] bool is_being_written(const std::filesystem::path& file);

}  // namespace murosimf::files
