/// files_read.h - which files were read while something was built: what a recording has to name.
///
///     const FilesRead files;
///     scene::Scene scene("walk");
///     for (const auto& file : files.list()) ...
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/files/moved_files.h"

namespace murosimf::files {

/// Notes the files that this thread opens while it lives; one at a time in a thread.
class FilesRead {
 public:
  FilesRead();
  ~FilesRead();
  FilesRead(const FilesRead&) = delete;
  FilesRead& operator=(const FilesRead&) = delete;

  /// What is read from now on is not noted.
  void stop();
  /// Each once, in the order of opening.
  [[nodiscard]] const std::vector<std::filesystem::path>& list() const { return list_; }
  /// Which of them, or of others, names have meant (data_path.h).
  [[nodiscard]] const FoundNames& names() const { return names_; }

 private:
  friend void note_file_read(const std::filesystem::path& file);
  friend void note_name_found(const std::string& key, const std::filesystem::path& file);
  std::vector<std::filesystem::path> list_;
  FoundNames names_;
};

/// For who opens a file.
void note_file_read(const std::filesystem::path& file);
/// For who finds one by a name, or (an empty path) none.
void note_name_found(const std::string& key, const std::filesystem::path& file);

}  // namespace murosimf::files
