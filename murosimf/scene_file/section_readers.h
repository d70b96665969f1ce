/// section_readers.h - readers of the sections of a scene file, each from the whole file's table into the spec.
///
/// All throw SetupError with file:line:column. For .cpp files only: it includes toml++.
#pragma once

#include <string_view>

#include "murosimf/files/toml_reader.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

inline constexpr double farthest_place = 1e4;  ///< [m] from the middle of the field

/// Throws SetupError at the key (or its table, if it is missing): "'key' message".
void require(bool condition, const files::TomlTable& table, std::string_view key, std::string_view message);

void read_air(const files::TomlTable& scene, SceneSpec& spec);
void read_field(const files::TomlTable& scene, SceneSpec& spec);
void read_view(const files::TomlTable& scene, SceneSpec& spec);
void read_viewpoints(const files::TomlTable& scene, SceneSpec& spec);
void read_light(const files::TomlTable& scene, SceneSpec& spec);
void read_ball(const files::TomlTable& scene, SceneSpec& spec);
void read_teams(const files::TomlTable& scene, SceneSpec& spec);
void read_robots(const files::TomlTable& scene, SceneSpec& spec);
void read_bodies(const files::TomlTable& scene, SceneSpec& spec);
void read_materials(const files::TomlTable& scene, SceneSpec& spec);
void read_communication(const files::TomlTable& scene, SceneSpec& spec);
void read_league(const files::TomlTable& scene, SceneSpec& spec);
void read_algorithms(const files::TomlTable& scene, SceneSpec& spec);

}  // namespace murosimf::scene_file
