/// files_read.h - the files that were read while something was built: contents of a recording.
///
///     const auto read = std::make_shared<FilesRead>();
///     scene::Scene scene("walk", {.files = {.noted = read}});
///     for (const auto& file : read->list()) ...
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/files/moved_files.h"

namespace murosimf::files {

/// One thread at a time.
class FilesRead {
 public:
  /// Each once, in the order of opening.
  [[nodiscard]] const std::vector<std::filesystem::path>& list() const noexcept { return list_; }
  /// Which of them, or of others, names have meant (data_path.h).
  [[nodiscard]] const FoundNames& names() const noexcept { return names_; }

  void note(const std::filesystem::path& file);
  /// `key`: look_up_key(); an empty path: none was found.
  void note_name(const std::string& key, const std::filesystem::path& file);
  /// In which some of them stand only as long as it lives.
  void keep(std::shared_ptr<const void> folder) { kept_.push_back(std::move(folder)); }

 private:
  std::vector<std::shared_ptr<const void>> kept_;
  std::vector<std::filesystem::path> list_;
  FoundNames names_;
};

}  // namespace murosimf::files
