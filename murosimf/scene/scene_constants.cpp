// Models of which a scene changes constants: an entity with other constants has a model of its own.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {
namespace {

/// Settings of constants of the entity.
std::vector<PropertySetting> constants_of(const SceneSpec& spec, const std::string& entity) {
  std::vector<PropertySetting> settings;
  for (const PropertySetting& setting : spec.settings) {
    const auto& names = setting.entities;
    const bool meant = std::find(names.begin(), names.end(), entity) != names.end();
    if (meant && is_constant(setting)) settings.push_back(setting);
  }
  return settings;
}

/// All whom the first setting means, for remarks that are true of all of them.
std::string owners_of(const std::vector<PropertySetting>& settings) {
  return fmt::format("{}", fmt::join(settings[0].entities, ", "));
}

}  // namespace

ModelPtr Scene::model_for(const std::string& entity, const ModelPtr& model) {
  const std::vector<PropertySetting> settings = constants_of(spec_, entity);
  if (settings.empty()) return model;
  std::string key;
  for (const PropertySetting& setting : settings) key += setting.where + "\n";
  ModelPtr& known = changed_models_[{model, key}];
  if (known) return known;
  std::vector<std::string> remarks;
  known = with_constants(*model, settings, remarks);
  for (const std::string& remark : remarks) notes_.push_back(fmt::format("{}: {}", owners_of(settings), remark));
  return known;
}

}  // namespace murosimf::scene
