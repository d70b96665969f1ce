/// allowed_files.h - limits the files that requests from a network may read: to those that the run was started with.
///
///     const auto allowed = std::make_shared<const AllowedFiles>(folders);
///     scene::Scene scene("walk", {.files = {.only_from = allowed}});   // finds and opens no other file
///
/// All readers open files by input_file.h and find them by data_path.h, which ask there (file_access.h); what lies outside is not even looked for, so
/// that a refusal does not tell whether it is there.
#pragma once

#include <filesystem>
#include <vector>

namespace murosimf::files {

class AllowedFiles {
 public:
  /// `folders` with all below them but hidden files (names that begin with a dot); `files` as they are. Missing ones
  /// allow nothing.
  explicit AllowedFiles(const std::vector<std::filesystem::path>& folders,
                        const std::vector<std::filesystem::path>& files = {});

  /// Decides by the path behind links and `..`; also for files that do not exist.
  [[nodiscard]] bool allows(const std::filesystem::path& file) const;

 private:
  std::vector<std::filesystem::path> named_folders_, named_files_;  // absolute, as they were given
  std::vector<std::filesystem::path> folders_, files_;              // the same without links
};

}  // namespace murosimf::files
