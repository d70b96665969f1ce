/// growing_file.h - a file that is written piece by piece, and whose pieces are safe from the end of this program at once.
///
/// Where a file of its name is already, it grows beside that as NAME.part and takes its place when it is whole; else it has its
/// name from the first piece on. Either way it is locked by this process (files/file_lock.h), so that no other run takes it, and what
/// is there of it is worth reading: a NAME.part that a run has left which was killed is kept under another name.
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
  /// at once. Throws SetupError: cannot write 'file': reason, which names the process that writes it.
  explicit GrowingFile(const std::filesystem::path& file);
  /// What has not begun leaves nothing behind, what is not whole stays where it is.
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// From now on pieces are on the disk. Throws SetupError likewise; then append() does, too.
  void begin();
  /// All of it or, as far as the system lets, nothing. Throws SetupError likewise.
  void append(std::string_view bytes);
  /// Returns when the disk has all of it. Throws SetupError likewise.
  void sync();
  /// It is whole: begins, if it has not, and takes the place of what had its name. Throws SetupError likewise.
  void finish();

  [[nodiscard]] std::uint64_t size() const { return size_; }                   ///< [byte]
  [[nodiscard]] std::uint32_t crc() const { return crc_; }                     ///< of all bytes (crc32.h)
  [[nodiscard]] const std::filesystem::path& grows_at() const { return at_; }  ///< since it began
  /// What an earlier run had left has this name now; empty: it had left nothing.
  [[nodiscard]] const std::filesystem::path& set_aside() const { return aside_; }

 private:
  void open_directly();
  void open_part();
  void put_aside();
  void take_name();
  void write(std::string_view bytes);
  [[noreturn]] void refuse(int error) const;
  [[noreturn]] void refuse(const std::string& reason) const;

  std::filesystem::path file_;  // as it was given
  files::OutputPlace place_;
  std::filesystem::path part_, at_, aside_;
  int descriptor_ = -1;
  bool begun_ = false, failed_ = false;
  std::string pending_;
  std::optional<files::CleanupGuard> empty_part_;
  std::uint64_t size_ = 0;
  std::uint64_t written_ = 0;  // [byte] of it on the disk
  std::uint32_t crc_ = 0;
};

/// What run is being recorded to this file, or has left a part of one beside it, in one line; empty: none.
[[nodiscard]] std::string part_diagnostic(const std::filesystem::path& file);

}  // namespace murosimf::recording
