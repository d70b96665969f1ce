/// remote_override.h - what may be set in a scene by those who ask for it over a network.
///
/// A list of what is allowed: what is not on it is refused, so that new keys are closed until somebody opens them here. A value is
/// numbers or booleans, or one word where a name is wanted; `model` and `motion` take the name of a file, which is looked for among
/// those that may be read (files/allowed_files.h).
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::scene_file {

/// Looks at the text alone (PATH=VALUE, as for --set), and for files beside the scene's `folder`. Throws SetupError in one line that
/// quotes nothing but the text.
void check_remote_override(const std::string& override_text, const std::filesystem::path& folder);

}  // namespace murosimf::scene_file
