/// body_section.h - [[bodies]] of a scene file: boxes, spheres, ramps and steps, one line each.
///
///     bodies = [{name = "crate", shape = "box", size = [0.2, 0.2, 0.1], mass = 1.0, position = [1, 0]},
///               {name = "ramp", shape = "box", size = [1, 1, 0.05], pitch_deg = -15, static = true}]
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/files/toml_reader.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// What may stand in one of the tables.
[[nodiscard]] const std::vector<std::string_view>& body_keys();

/// Reads them into spec.bodies. Throws SetupError with file:line:column.
void read_bodies(const files::TomlTable& scene, SceneSpec& spec);

/// Tables of the bodies whose names match, with * and ?.
[[nodiscard]] std::vector<toml::table*> bodies_called(toml::table& scene, const std::string& pattern);

}  // namespace murosimf::scene_file
