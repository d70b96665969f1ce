/// growing_file.h - a file that is written piece by piece, and keeps written pieces when the program ends in any way.
///
/// If a file of its name exists, the new one grows beside it as NAME.part and replaces it when complete; else it has its
/// name from the first piece on. In both cases it is locked by this process (files/file_lock.h), so that no other run uses it, and its
/// contents are preserved: a NAME.part of a run that was killed is kept under another name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "murosimf/files/cleanup_guard.h"
#include "murosimf/files/output_place.h"

namespace murosimf::recording {

class GrowingFile {
 public:
  /// Takes the lock. No file changes before begin(): pieces are kept in memory until then. Devices, pipes and descriptors are written
  /// at once. Throws SetupError: cannot write 'file': reason, with the process that writes it.
  explicit GrowingFile(const std::filesystem::path& file);
  /// A file that has not begun leaves nothing behind, an incomplete one remains.
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Writes pieces to the disk from now on. Throws SetupError likewise; then append() does, too.
  void begin();
  /// Appends everything or, as far as the system permits, nothing. Throws SetupError likewise.
  void append(std::string_view bytes);
  /// Returns when the disk has all of it. Throws SetupError likewise.
  void sync();
  /// Completes the file: begins, if it has not, replaces the file of its name, and releases the lock. Throws SetupError likewise.
  void finish();

  [[nodiscard]] std::uint64_t size() const { return size_; }                   ///< [byte]
  [[nodiscard]] std::uint32_t crc() const { return crc_; }                     ///< of all bytes (crc32.h)
  [[nodiscard]] const std::filesystem::path& grows_at() const { return at_; }  ///< valid after begin()
  /// New name of a file that an earlier run has left; empty: none.
  [[nodiscard]] const std::filesystem::path& set_aside() const { return aside_; }

 private:
  void open_directly();
  void open_part();
  void put_aside();
  void take_name();
  void replace_older();
  void write(std::string_view bytes);
  [[noreturn]] void refuse(int error) const;
  [[noreturn]] void refuse(const std::string& reason) const;

  std::filesystem::path file_;  // as given
  files::OutputPlace place_;
  std::filesystem::path part_, at_, aside_;
  int descriptor_ = -1;
  bool begun_ = false, failed_ = false, complete_ = false;
  std::string pending_;
  std::optional<files::CleanupGuard> empty_part_;
  std::uint64_t size_ = 0;
  std::uint64_t written_ = 0;  // [byte] on the disk
  std::uint32_t crc_ = 0;
};

/// One line about a run that records to this file, or has left a part beside it; empty: none.
[[nodiscard]] std::string part_diagnostic(const std::filesystem::path& file);

}  // namespace murosimf::recording
