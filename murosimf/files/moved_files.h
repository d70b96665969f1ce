/// moved_files.h - files of an earlier run that stand in another folder now: names mean the same files again, not those of today.
///
///     const MovedFiles moved(folder, names);    // folder/home/me/walk.toml takes the place of /home/me/walk.toml
///     scene::Scene scene("walk");
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace murosimf::files {

/// Which file a name has meant, by look_up_key(); an empty path: none.
using FoundNames = std::map<std::string, std::string>;

/// What decides which file a name means (data_path.h).
[[nodiscard]] std::string look_up_key(std::string_view name, std::string_view kind, std::string_view extension,
                                      const std::filesystem::path& beside);

/// The same for who must not learn an absolute name: of that only a hash is in it.
[[nodiscard]] std::string hidden_key(const std::string& key);

/// Concerns this thread while it lives; one at a time in a thread.
class MovedFiles {
 public:
  /// `folder` holds what was at /PATH as folder/PATH; `names` lead to where the files were.
  MovedFiles(std::filesystem::path folder, const FoundNames& names);
  ~MovedFiles();
  MovedFiles(const MovedFiles&) = delete;
  MovedFiles& operator=(const MovedFiles&) = delete;

  /// Of this thread; null: files are where they are.
  [[nodiscard]] static const MovedFiles* now() noexcept;
  /// Where what was at `path` stands.
  [[nodiscard]] std::filesystem::path to_here(const std::filesystem::path& path) const;
  /// Where what stands at `path` was.
  [[nodiscard]] std::filesystem::path to_there(const std::filesystem::path& path) const;
  /// What was found under that key, or its hidden one, as it was; null if nobody looked for it.
  [[nodiscard]] const std::string* found(const std::string& key) const;

 private:
  std::filesystem::path folder_;
  const FoundNames& names_;
};

}  // namespace murosimf::files
