#include "murosimf/scene/model_source.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/appearance/visual_meshes.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/file_access.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/model_constants.h"

namespace murosimf::scene {
namespace {

/// Settings of constants of the entity.
std::vector<scene_file::PropertySetting> constants_of(const scene_file::SceneSpec& spec, const std::string& entity) {
  std::vector<scene_file::PropertySetting> settings;
  for (const scene_file::PropertySetting& setting : spec.settings) {
    const auto& names = setting.entities;
    const bool meant = std::find(names.begin(), names.end(), entity) != names.end();
    if (meant && is_constant(setting)) settings.push_back(setting);
  }
  return settings;
}

/// All entities of the first setting, for diagnostics that apply to all of them.
std::string owners_of(const std::vector<scene_file::PropertySetting>& settings) {
  MUROSIMF_ASSERT(!settings.empty());
  return fmt::format("{}", fmt::join(settings[0].entities, ", "));
}

/// Checks access to visual meshes, which are read later, by the first renderer.
void check_visuals(const Model& model) {
  for (const std::string& file : appearance::visual_files(model)) {
    if (files::may_be_read(file)) continue;
    throw SetupError(
        fmt::format("{}: this mesh of model '{}' is in none of the folders that may be read here", file, model.name()));
  }
}

/// Supplied files contain words for MuJoCo without effect here, which need no note.
bool comes_with_the_program(const std::filesystem::path& file) {
  std::error_code none;
  return std::ranges::any_of(files::program_folders(), [&](const std::filesystem::path& folder) {
    return std::filesystem::equivalent(file.parent_path(), folder, none);
  });
}

/// "these words of its file have no effect here: option, geom.condim and 3 more; murosimf check kid21"
std::string unused_text(const std::vector<std::string>& words, const std::string& name) {
  constexpr std::ptrdiff_t most = 8;  // as many as fit into a line
  const auto shown = std::min(most, std::ssize(words));
  const auto more = std::ssize(words) - shown;
  return fmt::format("these words of its file have no effect here: {}{}; murosimf check {}",
                     fmt::join(words.begin(), words.begin() + shown, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "", name);
}

}  // namespace

const RobotKind& ModelSource::robot(const scene_file::RobotSpec& robot) {
  return read(robot.model, robot.where, {.lenient = lenient_, .xacro = robot.xacro, .body = robot.body});
}

const RobotKind& ModelSource::robot(const scene_file::BodySpec& body) {
  return read(body.model, body.where, {.lenient = lenient_});
}

const RobotKind& ModelSource::read(const std::string& name, const std::string& where,
                                   const robot_formats::ReaderOptions& options) {
  std::shared_ptr<const RobotKind>& known = robots_[{name, options.body, options.xacro}];
  if (known) return *known;
  const auto file =
      with_context(where, [&] { return files::find_data_file(name, "models", ".xml", spec_.file.parent_path()); });
  auto kind = assets_.robot(file, options);
  diagnostics_.warn(kind->warnings);
  if (!kind->unused.empty() && !comes_with_the_program(file)) diagnostics_.note(name, unused_text(kind->unused, name));
  check_materials(*kind->model);
  check_visuals(*kind->model);
  known = std::move(kind);
  return *known;
}

ModelPtr ModelSource::changed_for(const std::string& entity, const ModelPtr& model) {
  const std::vector<scene_file::PropertySetting> settings = constants_of(spec_, entity);
  if (settings.empty()) return model;
  // the places of the settings as a key: entities of one setting share the changed model
  std::string key;
  for (const scene_file::PropertySetting& setting : settings) key += setting.where + "\n";
  ModelPtr& known = with_constants_[{model, key}];
  if (known) return known;
  std::vector<std::string> diagnostics;
  known = with_constants(*model, settings, diagnostics);
  for (const std::string& diagnostic : diagnostics) diagnostics_.note(owners_of(settings), diagnostic);
  return known;
}

/// An unknown material would silently have the usual friction.
void check_materials(const Model& model, const MaterialTable& materials) {
  for (const int body : model.bodies()) {
    const Shapes* shapes = model.find(properties::shapes, body);
    if (!shapes) continue;
    for (const PlacedShape& placed : *shapes) {
      if (placed.surface.material.empty() || materials.knows(placed.surface.material)) continue;
      throw SetupError(fmt::format("model '{}', object '{}': {}", model.name(), model.objects()[body].name,
                                   unknown_name("material", placed.surface.material, materials.names())));
    }
  }
}

}  // namespace murosimf::scene
