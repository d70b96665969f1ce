/// allowed_files.h - which files may be read for those who ask over a network: what the run was started with, and nothing else.
///
///     const AllowedFiles allowed({"scenes", "models"});
///     const OnlyAllowed only(&allowed);   // as long as it lives, this thread finds and opens no other file
///     scene::Scene scene("walk");
///
/// All readers open files by input_file.h and find them by data_path.h, which ask here; what lies outside is not even looked for, so
/// that a refusal does not tell whether it is there.
#pragma once

#include <filesystem>
#include <vector>

namespace murosimf::files {

class AllowedFiles {
 public:
  /// `folders` with all below them but what is hidden (names that begin with a dot); `files` as they are. Those that are not there
  /// allow nothing.
  explicit AllowedFiles(const std::vector<std::filesystem::path>& folders,
                        const std::vector<std::filesystem::path>& files = {});

  /// By where links and `..` lead; also of files that are not there.
  [[nodiscard]] bool allows(const std::filesystem::path& file) const;

 private:
  std::vector<std::filesystem::path> named_folders_, named_files_;  // absolute, as they are called
  std::vector<std::filesystem::path> folders_, files_;              // the same without links
};

/// Concerns this thread while it lives. Null: as it was before, so that nothing inside widens what is allowed.
class OnlyAllowed {
 public:
  explicit OnlyAllowed(const AllowedFiles* allowed);
  ~OnlyAllowed();
  OnlyAllowed(const OnlyAllowed&) = delete;
  OnlyAllowed& operator=(const OnlyAllowed&) = delete;

 private:
  const AllowedFiles* before_;
};

/// Whether this thread may read it.
[[nodiscard]] bool may_be_read(const std::filesystem::path& file);
/// Whether there is anything that this thread may not read: then no other program may be started that reads for it.
[[nodiscard]] bool reads_are_limited();

}  // namespace murosimf::files
