/// allowed_files.h - limits the files that requests from a network may read: to those that the run was started with.
///
///     const AllowedFiles allowed({"scenes", "models"});
///     const OnlyAllowed only(&allowed);   // as long as it lives, this thread finds and opens no other file
///     scene::Scene scene("walk");
///
/// All readers open files by input_file.h and find them by data_path.h, which check the limit; files outside are not even looked for, so
/// that a refusal does not reveal whether they exist.
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

/// Limits this thread while it lives. Null: the limit in force remains, so that nothing inside widens it.
class OnlyAllowed {
 public:
  explicit OnlyAllowed(const AllowedFiles* allowed);
  ~OnlyAllowed();
  OnlyAllowed(const OnlyAllowed&) = delete;
  OnlyAllowed& operator=(const OnlyAllowed&) = delete;

 private:
  const AllowedFiles* before_;
};

/// Whether this thread may read the file.
[[nodiscard]] bool may_be_read(const std::filesystem::path& file);
/// Whether this thread is limited: then it must not start another program that reads on its behalf.
[[nodiscard]] bool reads_are_limited();

}  // namespace murosimf::files
