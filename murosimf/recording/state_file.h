/// state_file.h - the state of a run at an instant as a file from which it can go on: a recording of nothing but that, with the
/// scene, its files, and how the run was begun.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "murosimf/recording/attached_files.h"
#include "murosimf/recording/run_description.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

struct StateFileOptions {
  std::string program, command_line;
  RunDescription run;
  AttachedFiles files;
};

/// What stands in such a file. Between two steps. Throws SetupError.
[[nodiscard]] std::string state_bytes(scene::Scene& scene, const StateFileOptions& options);
/// The file is whole or not there at all.
void write_state(scene::Scene& scene, const std::filesystem::path& file, const StateFileOptions& options);

/// Goes on from the last whole state of such a file, of a recording, or of bytes of Scene::save. Throws SetupError that says what does
/// not fit, and changes nothing then.
void load_state(scene::Scene& scene, const std::filesystem::path& file);

/// The same of such a file's bytes, which messages call `name`.
void load_state_bytes(scene::Scene& scene, const std::string& bytes, const std::string& name);

/// SceneOptions::pushable of the run; nothing if the file does not say it.
[[nodiscard]] std::optional<bool> was_pushable(const std::filesystem::path& file);

/// What recordings and states say of their run: the metadata "murosimf".
[[nodiscard]] Metadata run_metadata(const scene::Scene& scene, const std::string& program,
                                    const std::string& command_line);
[[nodiscard]] Attachment text_attachment(const std::string& name, const std::string& text, Duration time);

}  // namespace murosimf::recording
