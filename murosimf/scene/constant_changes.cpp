#include "murosimf/scene/constant_changes.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/body_contact.h"
#include "murosimf/collision/ground_contact.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/scene_algorithms.h"
#include "murosimf/scene_file/assignment.h"
#include "murosimf/scene_file/material_section.h"

namespace murosimf::scene {
namespace {

/// As the scene was built.
ModelPtr built_model(const SceneParts& parts, const Entity& entity) {
  const auto found = parts.built_models.find(&entity);
  return found == parts.built_models.end() ? entity.model_ptr() : found->second;
}

/// With all changes of the entity. From the built model: what was in between leaves no trace.
ModelPtr changed_model(const SceneParts& parts, const Entity& entity, const std::vector<ConstantChange>& changes) {
  std::vector<scene_file::PropertySetting> settings;
  for (const ConstantChange& change : changes) {
    if (change.entity != entity.name()) continue;
    const std::string dot = change.object.empty() ? "" : ".";
    settings.push_back({.where = fmt::format("'{}.{}{}{}'", change.entity, change.object, dot, change.property),
                        .object = change.object,
                        .property = change.property,
                        .numbers = change.numbers});
  }
  const ModelPtr built = built_model(parts, entity);
  std::vector<std::string> what_follows;  // said once, at the build
  return settings.empty() ? built : with_constants(*built, settings, what_follows);
}

/// The later one replaces an earlier one of the same place, and comes last: patterns may overlap.
std::vector<ConstantChange> with(std::vector<ConstantChange> changes, ConstantChange change) {
  std::erase_if(changes, [&](const ConstantChange& other) {
    return other.entity == change.entity && other.object == change.object && other.property == change.property;
  });
  changes.push_back(std::move(change));
  return changes;
}

std::vector<ConstantChange> with(const SceneParts& parts, const scene_file::PropertySetting& setting,
                                 const std::string& entity) {
  return with(parts.constants.models, {entity, setting.object, setting.property, setting.numbers});
}

Entity& changeable(const SceneParts& parts, const std::string& name) {
  Entity& entity = parts.simulation->world().entity(name);
  if (&entity == parts.ball) throw SetupError("constants of the ball are keys: 'ball.mass', 'ball.radius'");
  return entity;
}

/// Algorithms may point into the built model for good: it stays.
void exchange_model(SceneParts& parts, Entity& entity, ModelPtr model, LevelStart start) {
  const auto robot = std::ranges::find(parts.spec.robots, entity.name(), &scene_file::RobotSpec::name);
  const catalog::LevelOptions options =
      robot == parts.spec.robots.end() ? catalog::LevelOptions{} : level_options(parts, *robot);
  parts.built_models.try_emplace(&entity, entity.model_ptr());
  const auto level = [&](Setup& setup) { return catalog::make_level(entity.level, setup, options); };
  parts.simulation->exchange_model(entity, std::move(model), level, start);
}

std::string text_of(const scene_file::SceneEvent& event) {
  return fmt::format("{}.{}={}", event.section, event.key, event.value);
}

std::vector<std::string> with(std::vector<std::string> surfaces, const std::string& text) {
  const std::string path = text.substr(0, text.find('=') + 1);
  std::erase_if(surfaces, [&](const std::string& other) { return other.starts_with(path); });
  surfaces.push_back(text);
  return surfaces;
}

double friction_of(const std::string& text) {
  const scene_file::Assignment assignment = scene_file::split_assignment(text, fmt::format("'{}'", text));
  const std::vector<double> numbers = scene_file::property_setting(assignment, 0, {}).numbers;
  if (numbers.size() == 1 && numbers[0] >= 0) return numbers[0];
  throw SetupError(fmt::format("'{}': the friction of the field is a number, at least 0", text));
}

/// That of the build with all changes.
MaterialTable changed_materials(const SceneParts& parts, const std::vector<std::string>& surfaces) {
  scene_file::SceneSpec spec;
  spec.field = parts.spec.field;
  spec.materials = parts.built_materials.value_or(parts.spec.materials);
  if (surfaces.empty()) return spec.materials;
  std::vector<scene_file::MaterialChange> changes;
  for (const std::string& text : surfaces) {
    if (!scene_file::take_material_change(text, changes)) spec.field.friction = friction_of(text);
  }
  scene_file::apply_material_changes(changes, spec);
  return spec.materials;
}

void put_surfaces_in_force(SceneParts& parts, const std::vector<std::string>& surfaces) {
  MaterialTable next = changed_materials(parts, surfaces);
  if (!parts.built_materials) parts.built_materials = parts.spec.materials;
  for (collision::GroundContact* contact : parts.ground_contacts) contact->exchange_materials(next);
  parts.body_contact->exchange_materials(next);
  parts.spec.materials = std::move(next);
  parts.constants.surfaces = surfaces;
}

std::vector<ConstantChange> of_entity(const std::vector<ConstantChange>& changes, const Entity& entity) {
  std::vector<ConstantChange> own;
  std::ranges::copy_if(changes, std::back_inserter(own), [&](const auto& one) { return one.entity == entity.name(); });
  return own;
}

}  // namespace

void check_constant(const SceneParts& parts, const scene_file::PropertySetting& setting, const std::string& entity) {
  (void)changed_model(parts, changeable(parts, entity), with(parts, setting, entity));
}

void change_constant(SceneParts& parts, const scene_file::PropertySetting& setting, const std::string& entity) {
  Entity& changed = changeable(parts, entity);
  std::vector<ConstantChange> changes = with(parts, setting, entity);
  exchange_model(parts, changed, changed_model(parts, changed, changes), LevelStart::in_motion);
  parts.constants.models = std::move(changes);
  const std::string dot = setting.object.empty() ? "" : ".";
  parts.simulation->record(
      fmt::format("{}: {}{}{} {:g}", entity, setting.object, dot, setting.property, fmt::join(setting.numbers, ", ")));
}

void check_surfaces(const SceneParts& parts, const scene_file::SceneEvent& event) {
  with_context(event.where, [&] { (void)changed_materials(parts, with(parts.constants.surfaces, text_of(event))); });
}

void change_surfaces(SceneParts& parts, const scene_file::SceneEvent& event) {
  put_surfaces_in_force(parts, with(parts.constants.surfaces, text_of(event)));
}

/// Only what differs: an exchange of the model begins its algorithms anew.
void put_in_force(SceneParts& parts, const ChangedConstants& constants) {
  if (constants == parts.constants) return;
  for (Entity* entity : parts.moving_entities) {
    if (of_entity(constants.models, *entity) == of_entity(parts.constants.models, *entity)) continue;
    exchange_model(parts, *entity, changed_model(parts, *entity, constants.models), LevelStart::anew);
  }
  parts.constants.models = constants.models;
  if (constants.surfaces != parts.constants.surfaces) put_surfaces_in_force(parts, constants.surfaces);
}

}  // namespace murosimf::scene
