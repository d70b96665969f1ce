/// growing_file.h - a file that is written piece by piece, and whose pieces are safe from the end of this program at once.
///
/// Unlike other results (files/output_file.h) it has its name from the beginning: what is there of it is worth reading.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace murosimf::recording {

class GrowingFile {
 public:
  /// Replaces what has this name. Throws SetupError: cannot write 'file': reason.
  explicit GrowingFile(const std::filesystem::path& file);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// All of it or, as far as the system lets, nothing. Throws SetupError likewise.
  void append(std::string_view bytes);
  /// Returns when the disk has all of it. Throws SetupError likewise.
  void sync();

  [[nodiscard]] std::uint64_t size() const { return size_; }  ///< [byte]
  [[nodiscard]] std::uint32_t crc() const { return crc_; }    ///< of all bytes (crc32.h)

 private:
  [[noreturn]] void refuse(int error);

  std::filesystem::path file_;
  int descriptor_;
  std::uint64_t size_ = 0;
  std::uint32_t crc_ = 0;
};

}  // namespace murosimf::recording
