/// recorded_paths.h - what recordings call the files of a run: without the folders above them, which are nobody else's business.
///
///     /program/scenes/walk.toml    comes with the program (files/data_path.h)
///     /user/robots/mine.urdf       of the user: below the folder that all of these share; where some are in one's home folder and others
///                                  are not, those are /user_2/...
///
/// Files keep their places relative to each other, so that names in them lead where they led.
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
  /// Of none: only what comes with the program.
  RecordedPaths();
  /// `files` and `names` as files::FilesRead notes them.
  RecordedPaths(const std::vector<std::filesystem::path>& files, const files::FoundNames& names);

  [[nodiscard]] std::string reduced(const std::filesystem::path& file) const;
  /// All such files in a text; another name in the home folder begins with "~".
  [[nodiscard]] std::string in_text(const std::string& text) const;
  /// Likewise, and of every other absolute name in a command line, and of the program, the last part alone.
  [[nodiscard]] std::string in_command_line(const std::string& line) const;
  /// With `names`, as files::FilesRead notes them: names of files that are in it lead to them as before.
  [[nodiscard]] RunDescription in_description(RunDescription run) const;
  /// From "/user" to where it may be found again: "~/robots" or, outside of the home folder, "robots" below the working folder.
  [[nodiscard]] TextMap folders() const;

 private:
  void add(const std::filesystem::path& folder, const std::string& name);

  std::vector<std::pair<std::string, std::string>> roots_;  // folder and what it is called; longer ones first
};

/// Where a file may be now that is so called, the most probable place first; `recording`: that says so, `folders`: in it.
[[nodiscard]] std::vector<std::filesystem::path> places_of(const std::filesystem::path& reduced,
                                                           const std::filesystem::path& recording,
                                                           const TextMap& folders);

}  // namespace murosimf::recording
