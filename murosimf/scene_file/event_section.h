/// event_section.h - changes of a scene at given times: its timeline, and --at.
///
///     [[events]]
///     time = 3.0                                   # [s]
///     set = "blue1.level = articulated_dynamics"   # or a list of such texts; also "light.brightness = 0.3"
///
/// For .cpp files only: it includes toml++.
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// Keys of a robot that can change while it runs.
[[nodiscard]] const std::vector<std::string_view>& exchangeable_keys();

/// A change PATH = VALUE at a time [s]; `where` is for messages. Of the tables of the scene only names and teams are used. Throws
/// SetupError for unknown entities, keys and names of levels and laws.
[[nodiscard]] SceneEvent read_event(toml::table& scene, double time, const std::string& text, const std::string& where);

/// The events of the file and of --at ("TIME:PATH=VALUE"), ordered by time; equal times in the order of their
/// definition, the file's first. Throws SetupError for unknown entities, keys and names of levels and laws.
[[nodiscard]] std::vector<SceneEvent> read_events(toml::table& scene, const std::vector<std::string>& at_options);

}  // namespace murosimf::scene_file
