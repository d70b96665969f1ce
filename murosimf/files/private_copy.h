/// private_copy.h - a copy of a shared library for the loader that no other process can write to.
///
/// A loaded library is a map of its file: a program that writes into the file (cp, scp, rsync --inplace, a compiler) changes code that runs,
/// and one that truncates it makes the simulator crash. So the file is read once, checked to be complete, and a copy of it is loaded.
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::files {

/// Exists until it is loaded. Stands beside the file, under a hidden name of its own, so that files which the library looks
/// for beside itself, by $ORIGIN or dladdr, are found; in memory where that folder cannot be written to.
class PrivateCopy {
 public:
  /// Throws SetupError in one line that begins with `shown`: the file cannot be read, is no shared library, or is not complete.
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

/// Whether these bytes are a complete ELF file: its segments and sections end within it. Files that are being written are not. Bytes of
/// no ELF file count as complete: the loader reports what is wrong with them.
[[nodiscard]] bool is_whole_library(const std::string& bytes);

/// Whether another program has the file open for writing. False where that cannot be determined.
[[nodiscard]] bool is_being_written(const std::filesystem::path& file);

}  // namespace murosimf::files
