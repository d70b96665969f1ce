/// output_file.h - results go to files that are whole or not there at all.
///
/// Every result of a command is claimed first (file_roles.h), written under another name in the folder of the file, and renamed
/// when it is whole. Recordings grow for a long time, and have rules of their own (recording/mcap/growing_file.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "murosimf/files/cleanup_guard.h"

namespace murosimf::files {

/// Throws SetupError if a file of this name could not be created now: found out before a long run, not after it. Nothing changes.
void check_writable(const std::filesystem::path& file);

/// Keeps what was there before until all of the new is there, and keeps its permissions. Follows symbolic links. Devices, pipes and
/// descriptors (/dev/stdout) are written directly. Throws SetupError: cannot write 'file': reason.
void write_file(const std::filesystem::path& file, const std::string& bytes);

/// A file in the making, for who writes it piece by piece, or has another program write it.
class PartFile {
 public:
  enum class Extension : std::uint8_t { part, of_file };
  enum class Replaces : std::uint8_t { no_input, input_too };

  /// `extension`: of the name until then: ".part", or that of the file, for programs that look at it. Throws SetupError as
  /// check_writable, and for devices, pipes and descriptors.
  explicit PartFile(const std::filesystem::path& file, Extension extension = Extension::part);
  /// Removes what has not become the file.
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  /// Where it is written; nothing is there at first.
  [[nodiscard]] const std::filesystem::path& path() const { return part_; }
  /// It is whole: on the disk, and then in the place of the file. Throws SetupError, and keeps what was there; also if that is an
  /// input of this command (file_roles.h), unless it `replaces` that on purpose.
  void commit(Replaces replaces = Replaces::no_input);

 private:
  std::filesystem::path file_, place_, part_;
  std::optional<CleanupGuard> half_;
};

}  // namespace murosimf::files
