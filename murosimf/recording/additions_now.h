/// additions_now.h - what has come to a scene that runs, as attachments of a recording or of the file of a state (recorded_addition.h).
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "murosimf/recording/attached_files.h"
#include "murosimf/recording/recorded_paths.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

/// Takes robots and bodies in their order, and writes each of them once.
class AdditionsNow {
 public:
  /// `files`: whether what they were read from is taken, too.
  explicit AdditionsNow(bool files) : with_files_(files) {}

  /// Names of files that are attached already.
  void know(const AttachedFiles& files);
  /// Those that have come since the last call, between two steps, with what stands in their files now; `first`: the instant of the first frame, of which
  /// those are part that came before. Gives `paths` the files. Throws SetupError if one cannot be read.
  void take(const scene::Scene& scene, Duration first, RecordedPaths& paths);
  /// What was taken since the last call, as attachments of the instant `now`.
  void write(McapWriter& file, Duration now);

 private:
  void take_files(const scene::Scene& scene, RecordedPaths& paths);
  [[nodiscard]] std::string json_of(const scene::Scene& scene, const scene::Addition& addition, Duration first,
                                    const RecordedPaths& paths) const;

  bool with_files_;
  AttachedFiles files_;  // not written yet, as the texts
  std::vector<std::string> texts_;
  std::set<std::string> known_files_;    // by their names in the recording
  std::size_t taken_ = 0, written_ = 0;  // additions
};

}  // namespace murosimf::recording
