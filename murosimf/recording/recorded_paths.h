/// recorded_paths.h - names of a run's files in recordings: without the folders above them, which are private.
///
///     /program/scenes/walk.toml    supplied with the program (files/data_path.h)
///     /user/robots/mine.urdf       of the user: below the folder that all of these share; if some are in a home folder and others
///                                  are not, those are /user_2/...
///
/// Files keep their relative places, so that references between them remain valid.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/files/moved_files.h"
#include "murosimf/recording/mcap/mcap_records.h"
#include "murosimf/recording/run_description.h"

namespace murosimf::recording {

class RecordedPaths {
 public:
  /// For no files: only supplied ones are known.
  RecordedPaths();
  /// `files` and `names` as files::FilesRead notes them.
  RecordedPaths(const std::vector<std::filesystem::path>& files, const files::FoundNames& names);

  /// Of files that are read later: those that are in none of its folders get further ones, the others keep their names.
  void extend(const std::vector<std::filesystem::path>& files, const files::FoundNames& names);

  [[nodiscard]] std::string reduced(const std::filesystem::path& file) const;
  /// Replaces all such files in a text; other names in the home folder begin with "~".
  [[nodiscard]] std::string in_text(const std::string& text) const;
  /// Likewise; of every other absolute name in a command line, and of the program, only the last part is kept.
  [[nodiscard]] std::string in_command_line(const std::string& line) const;
  /// With `names`, as files::FilesRead notes them: names in the description lead to the same files.
  [[nodiscard]] RunDescription in_description(RunDescription run) const;
  /// Possible places of "/user" for later: "~/robots" or, outside of the home folder, "robots" below the working folder.
  [[nodiscard]] TextMap folders() const;

 private:
  void add(const std::filesystem::path& folder, const std::string& name);

  std::vector<std::pair<std::string, std::string>> roots_;  // folder and its name in recordings; longer ones first
  std::size_t areas_ = 0;                                   // of the user
};

/// Possible places of a file with this name, the most probable first; `recording`: the file that contains the name, `folders`: from it.
[[nodiscard]] std::vector<std::filesystem::path> places_of(const std::filesystem::path& reduced,
                                                           const std::filesystem::path& recording,
                                                           const TextMap& folders);

}  // namespace murosimf::recording
