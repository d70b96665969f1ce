/// state_file.h - the state of a run at an instant as a file from which it can continue: a recording with that state only, the
/// scene, its files, the start parameters of the run, and the robots and bodies that have come to it, with their files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "murosimf/recording/attached_files.h"
#include "murosimf/recording/recorded_paths.h"
#include "murosimf/recording/run_description.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

struct StateFileOptions {
  std::string program, command_line;
  RunDescription run;
  AttachedFiles files;
  RecordedPaths paths{};  ///< names of these files
};

/// The contents of such a file. Between two steps. Throws SetupError.
[[nodiscard]] std::string state_bytes(scene::Scene& scene, const StateFileOptions& options);
/// The file is complete or absent.
void write_state(scene::Scene& scene, const std::filesystem::path& file, const StateFileOptions& options);

/// Continues from the last whole state of such a file, of a recording, or of bytes of Scene::save. What has come to that run, and not to
/// this scene, is added first. Throws SetupError with the mismatch, and changes nothing then, except that what was added stays, absent.
void load_state(scene::Scene& scene, const std::filesystem::path& file);

/// The same for such a file's bytes, called `name` in messages; they come from elsewhere, so nothing is added.
void load_state_bytes(scene::Scene& scene, const std::string& bytes, const std::string& name);

/// SceneOptions::pushable of the run; nothing if the file does not contain it.
[[nodiscard]] std::optional<bool> was_pushable(const std::filesystem::path& file);

/// Description of the run in recordings and states: the metadata "murosimf".
[[nodiscard]] Metadata run_metadata(const scene::Scene& scene, const std::string& program,
                                    const std::string& command_line);
[[nodiscard]] Attachment text_attachment(const std::string& name, const std::string& text, Duration time);

}  // namespace murosimf::recording
