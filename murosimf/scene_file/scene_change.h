/// scene_change.h - "PATH = VALUE" for an existing scene, as in its events and --at (event_section.h).
#pragma once

#include <string>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// The change as an event at the time 0. Throws SetupError for unknown entities, keys and names of levels and laws.
[[nodiscard]] SceneEvent read_change(const SceneSpec& spec, const std::string& text);

}  // namespace murosimf::scene_file
