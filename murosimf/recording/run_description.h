/// run_description.h - how a recorded run was begun: with its files, all that is needed to repeat it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/files/moved_files.h"
#include "murosimf/model/time.h"

namespace murosimf::recording {

struct RunDescription {
  std::string scene;  ///< as its user named it
  std::uint64_t seed = 0;
  std::vector<std::string> overrides, events, pushes;  ///< as in scene/scene_options.h
  std::vector<std::string> plugins;                    ///< files
  bool libraries = false, lenient = false, cameras = true;
  bool pushable = false;  ///< everybody who moves, not only whom its file pushes: it was steered
  std::vector<std::string>
      channels{};  ///< by which others took part, what came is recorded (runtime/external_input_log.h)
  std::vector<std::string> outside{};  ///< what else acted on it and is not recorded: "a GameController"
  Duration start{};                    ///< later than 0 if it went on from a state
  files::FoundNames names{};           ///< which files its names have meant
};

/// JSON, the attachment "run.json" of a recording.
[[nodiscard]] std::string to_json(const RunDescription& run);
/// Throws SetupError.
[[nodiscard]] RunDescription parse_run_description(const std::string& json);

}  // namespace murosimf::recording
