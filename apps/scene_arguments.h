/// scene_arguments.h - the options of commands that run a scene: which one, and how it is changed and stepped.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/command.h"
#include "murosimf/scene/scene.h"

namespace murosimf::app {

struct SceneArguments {
  std::string file;
  int threads = 1;
  bool no_lanes = false;
  std::optional<std::int64_t> seed;  ///< from 0
  std::vector<std::string> overrides, events, pushes, plugins;
  bool lenient = false, libraries = false;
  std::shared_ptr<const files::AllowedFiles> only_from{};  ///< SceneOptions::files
};

inline constexpr const char* scene_meaning = "Scene file (TOML), or the name of one that comes with the program";

/// `meaning`: of a command that takes something else in the place of a scene, too.
void add_scene(const Command& command, SceneArguments& scene, const char* meaning = scene_meaning);
/// For scene::Scene, with plug-ins loaded; a signal stops it (interruption.h). Throws SetupError.
[[nodiscard]] scene::SceneOptions options_of(const SceneArguments& scene);

// Some of them alone.
void add_scene_file(const Command& command, std::string& file, const char* meaning = scene_meaning);
/// 0 to the largest std::int64_t.
void add_seed(const Command& command, std::optional<std::int64_t>& seed);
void add_seed(const Command& command, std::optional<std::uint64_t>& seed);
void add_lenient(const Command& command, bool& lenient);
void add_no_cameras(const Command& command, bool& no_cameras);
void add_libraries(const Command& command, bool& libraries);
/// Which robot of a file.
void add_body(const Command& command, std::string& body);
/// Arguments of a robot file with macros.
void add_xacro(const Command& command, std::vector<std::string>& arguments);
/// Values by name. Throws SetupError for what is not name:=value.
std::map<std::string, std::string> xacro_values(const std::vector<std::string>& arguments);
/// Files for catalog::load_plugin.
void add_plugins(const Command& command, std::vector<std::string>& plugins);
/// Throws SetupError.
void load_plugins(const std::vector<std::string>& plugins);

}  // namespace murosimf::app
