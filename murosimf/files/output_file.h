/// output_file.h - writes results to files that are complete or do not exist.
///
/// Every result of a command is claimed first (file_roles.h), written under another name in the folder of the file, and renamed
/// when it is complete. Recordings grow for a long time, and have their own rules (recording/mcap/growing_file.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "murosimf/files/cleanup_guard.h"

namespace murosimf::files {

/// Throws SetupError if a file of this name could not be created: to be reported before a long run, not after it. Changes nothing.
void check_writable(const std::filesystem::path& file);

/// Writes a file, keeps the previous one until the new one is complete, and its permissions. Follows symbolic links. Devices, pipes and
/// descriptors (/dev/stdout) are written directly. Throws SetupError: cannot write 'file': reason.
void write_file(const std::filesystem::path& file, const std::string& bytes);
/// The same for a file that this command has read, and replaces on purpose.
void replace_file(const std::filesystem::path& file, const std::string& bytes);

/// A file in progress, for writing in pieces, or by another program.
class PartFile {
 public:
  enum class Extension : std::uint8_t { part, of_file };
  enum class Replaces : std::uint8_t { no_input, input_too };

  /// `extension` of the temporary name: ".part", or that of the file, for programs that use it to choose a format. Throws SetupError as
  /// check_writable, and for devices, pipes and descriptors.
  explicit PartFile(const std::filesystem::path& file, Extension extension = Extension::part);
  /// Removes the temporary file unless commit() has renamed it.
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// The temporary name; no such file exists at first.
  [[nodiscard]] const std::filesystem::path& path() const { return part_; }
  /// Completes the file: writes it to the disk, and renames it. Throws SetupError, and keeps the previous file; also if that is an
  /// input of this command (file_roles.h), unless it `replaces` that on purpose.
  void commit(Replaces replaces = Replaces::no_input);

 private:
  std::filesystem::path file_, place_, part_;
  std::optional<CleanupGuard> half_;
};

}  // namespace murosimf::files
