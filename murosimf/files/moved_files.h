/// moved_files.h - files of an earlier run that are stored in another folder: names refer to those files, not to present ones.
///
///     const auto moved = std::make_shared<const MovedFiles>(folder, names);  // folder/home/me/walk.toml takes the place of /home/me/walk.toml
///     scene::Scene scene("walk", {.files = {.moved = moved}});
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace murosimf::files {

/// The file that a name was resolved to, by look_up_key(); an empty path: none.
using FoundNames = std::map<std::string, std::string>;

/// Everything that decides which file a name refers to (data_path.h).
[[nodiscard]] std::string look_up_key(std::string_view name, std::string_view kind, std::string_view extension,
                                      const std::filesystem::path& beside);

/// The same without an absolute name, which must not be disclosed: only its hash is in it.
[[nodiscard]] std::string hidden_key(const std::string& key);

class MovedFiles {
 public:
  /// `folder` holds what was at /PATH as folder/PATH; `names` lead to where the files were.
  MovedFiles(std::filesystem::path folder, FoundNames names) : folder_(std::move(folder)), names_(std::move(names)) {}

  /// Where what was at `path` stands.
  [[nodiscard]] std::filesystem::path to_here(const std::filesystem::path& path) const;
  /// The original place of the file that is stored at `path`.
  [[nodiscard]] std::filesystem::path to_there(const std::filesystem::path& path) const;
  /// The recorded file of that key, or of its hidden one; null if it was not looked for.
  [[nodiscard]] const std::string* found(const std::string& key) const;

 private:
  std::filesystem::path folder_;
  FoundNames names_;
};

}  // namespace murosimf::files
