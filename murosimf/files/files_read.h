/// files_read.h - which files were read while something was built: what a recording has to name.
///
///     const FilesRead files;
///     scene::Scene scene("walk");
///     for (const auto& file : files.list()) ...
#pragma once

#include <filesystem>
#include <vector>

namespace murosimf::files {

/// Notes the files that this thread opens while it lives; one at a time in a thread.
class FilesRead {
 public:
  FilesRead();
  ~FilesRead();
  FilesRead(const FilesRead&) = delete;
  FilesRead& operator=(const FilesRead&) = delete;

  /// Each once, in the order of opening.
  [[nodiscard]] const std::vector<std::filesystem::path>& list() const { return list_; }

 private:
  friend void note_file_read(const std::filesystem::path& file);
  std::vector<std::filesystem::path> list_;
};

/// For who opens a file.
void note_file_read(const std::filesystem::path& file);

}  // namespace murosimf::files
