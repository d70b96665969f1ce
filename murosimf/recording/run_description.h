/// run_description.h - start parameters of a recorded run: with its files, everything needed to repeat it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/files/moved_files.h"
#include "murosimf/world/time.h"

namespace murosimf::recording {

struct RunDescription {
  std::string scene;  ///< as named by its user
  std::uint64_t seed = 0;
  std::vector<std::string> overrides, events, pushes;  ///< as in scene/scene_options.h
  std::vector<std::string> plugins;                    ///< files
  bool libraries = false, lenient = false, cameras = true;
  bool pushable = false;  ///< all moving entities, not only those pushed in its file: the run was controlled by others
  std::vector<std::string> channels{};  ///< of external participants with recorded input (runtime/external_input_log.h)
  std::vector<std::string> outside{};   ///< other participants without a record: "a GameController"
  Duration start{};                     ///< later than 0 if it continued from a state
  files::FoundNames names{};            ///< files that its names denoted
};

/// JSON, the attachment "run.json" of a recording.
[[nodiscard]] std::string to_json(const RunDescription& run);
/// Throws SetupError.
[[nodiscard]] RunDescription parse_run_description(const std::string& json);

}  // namespace murosimf::recording
