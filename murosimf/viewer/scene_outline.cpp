#include "murosimf/viewer/scene_outline.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/scene_file/field.h"

namespace murosimf::viewer {

SceneOutline::SceneOutline(const scene::Scene& scene) : entities_(outline_of(scene)) {
  const scene_file::FieldSize& size = scene_file::field_size(scene.spec().field.size);
  half_length_ = 0.5 * size.length;
  half_width_ = 0.5 * size.width;
  goal_half_width_ = scene.spec().field.goals ? 0.5 * size.goal_width : 0;
  for (std::size_t i = 0; i < entities_.size(); ++i) {
    if (entities_[i].is_ball) ball_ = static_cast<int>(i);
  }
}

int SceneOutline::robot(int number) const noexcept {
  const auto found = std::ranges::find(entities_, number, &EntityOutline::label);
  return found == entities_.end() ? -1 : static_cast<int>(found - entities_.begin());
}

int SceneOutline::entity_named(std::string_view name) const noexcept {
  const auto found = std::ranges::find(entities_, name, &EntityOutline::name);
  return found == entities_.end() ? -1 : static_cast<int>(found - entities_.begin());
}

std::string SceneOutline::path_text(const ObjectPath& path) const {
  const EntityOutline& whom = of(path.entity);
  return fmt::format("{}.{}", whom.name, whom.model->objects()[static_cast<std::size_t>(path.object)].name);
}

ObjectPath SceneOutline::path_of(const std::string& text) const {
  const auto dot = text.find('.');
  const int entity = entity_named(text.substr(0, dot));
  if (entity < 0) {
    std::vector<std::string_view> names;
    for (const EntityOutline& whom : entities_) names.push_back(whom.name);
    throw SetupError(unknown_name("entity", text.substr(0, dot), names));
  }
  if (dot == std::string::npos) return {entity, 0};
  return {entity, of(entity).model->object_index(text.substr(dot + 1))};
}

}  // namespace murosimf::viewer
