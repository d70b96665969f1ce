/// overrides.h - --set PATH=VALUE: changes a scene's table before it is read.
///
/// For .cpp files only: it includes toml++.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// Applies one override. Settings of properties have no place in the table; they are appended to `settings`.
void apply_override(toml::table& scene, const std::string& override_text, std::vector<PropertySetting>& settings);

}  // namespace murosimf::scene_file
