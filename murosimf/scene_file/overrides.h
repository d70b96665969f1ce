/// overrides.h - --set PATH=VALUE: changes a scene's table before it is read.
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

// What may stand in a scene file.
[[nodiscard]] const std::vector<std::string_view>& scene_keys();
[[nodiscard]] const std::vector<std::string_view>& robot_keys();
/// Of the tables that a scene has once ("ball"); empty for any other name.
[[nodiscard]] std::vector<std::string_view> table_keys(std::string_view table);

/// Applies one override. Settings of properties cannot enter the table; they are appended to `settings`.
void apply_override(toml::table& scene, const std::string& override_text, std::vector<PropertySetting>& settings);

}  // namespace murosimf::scene_file
