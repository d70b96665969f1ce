/// files_read.h - the files that were read while something was built: contents of a recording.
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

/// Records the files that this thread opens while it lives; one at a time in a thread.
class FilesRead {
 public:
  FilesRead();
  ~FilesRead();
  FilesRead(const FilesRead&) = delete;
  FilesRead& operator=(const FilesRead&) = delete;

  /// Stops recording.
  void stop();
  /// Each once, in the order of opening.
  [[nodiscard]] const std::vector<std::filesystem::path>& list() const { return list_; }
  /// The files that names were resolved to (data_path.h).
  [[nodiscard]] const FoundNames& names() const { return names_; }

 private:
  friend void note_file_read(const std::filesystem::path& file);
  friend void note_name_found(const std::string& key, const std::filesystem::path& file);
  std::vector<std::filesystem::path> list_;
  FoundNames names_;
};

/// To be called when a file is opened.
void note_file_read(const std::filesystem::path& file);
/// To be called when a name was resolved to a file, or (an empty path) to none.
void note_name_found(const std::string& key, const std::filesystem::path& file);

}  // namespace murosimf::files
