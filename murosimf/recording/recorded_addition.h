/// recorded_addition.h - robots and bodies that came to a run while it went on: each is an attachment "additions/NUMBER.json", in their order.
///
/// It says when, and what Scene::add got. The files that it was read from are attached like those of the scene (attached_files.h).
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "murosimf/files/moved_files.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/scene/scene.h"

namespace murosimf::recording {

struct RecordedAddition {
  Duration time{};                      ///< it came before the step of that time
  bool in_state = true;                 ///< whether a state of that very time has it
  std::vector<std::string> channels{};  ///< of external participants with recorded input, since then
  files::FoundNames names{};            ///< files that names in its own files denoted
  std::variant<scene_file::RobotSpec, scene_file::BodySpec> what;
};

/// Name of attachments.
inline constexpr std::string_view additions_prefix = "additions/";

/// JSON. Of a robot all but changes of its sensors and collisions, its library and the link to it, and of a body all but meshes and uneven
/// ground: what Scene::add gets has none of these. Throws SetupError for a body of another shape.
[[nodiscard]] std::string to_json(const RecordedAddition& addition);
/// Throws SetupError.
[[nodiscard]] RecordedAddition parse_addition(const std::string& json);

/// All of a recording, in their order. Throws SetupError.
[[nodiscard]] std::vector<RecordedAddition> recorded_additions(const McapReader& file);

/// Whether a state of that time has it.
[[nodiscard]] inline bool is_part_of(const RecordedAddition& addition, Duration state) {
  return addition.time < state || (addition.time == state && addition.in_state);
}

/// Adds it by Scene::add. Throws SetupError.
void add_to(scene::Scene& scene, const RecordedAddition& addition);

}  // namespace murosimf::recording
