/// remote_override.h - overrides of a scene that may come over a network.
///
/// A list of what is allowed: everything else is refused, so that new keys are closed until they are added here. A value consists of
/// numbers or booleans, or one word where a name is expected; `model` and `motion` take the name of a file, which is searched among
/// those that may be read (files/allowed_files.h).
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::scene_file {

/// Checks the text alone (PATH=VALUE, as for --set), and files in the scene's `folder`. Throws SetupError in one line that
/// quotes nothing but the text.
void check_remote_override(const std::string& override_text, const std::filesystem::path& folder);

}  // namespace murosimf::scene_file
