#include "murosimf/scene/scene_settings.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/model/properties.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/property_checks.h"
#include "murosimf/scene_file/setting_targets.h"

namespace murosimf::scene {
namespace {

constexpr Duration some_cycles = std::chrono::milliseconds(50);  // of any controller

bool is_target(std::string_view property) {
  return property == properties::joint_target.name || property == properties::joint_velocity_target.name;
}

/// Schedules a check after the controller's next cycles, which may overwrite the value.
void watch(SceneParts& parts, const scene_file::PropertySetting& setting, const std::string& entity) {
  const Entity& robot = parts.simulation->world().entity(entity);
  const auto writers = parts.simulation->writers_of(robot, setting.property);
  if (!is_target(setting.property) || writers.empty()) return;
  const std::string name = setting_path(setting, robot);
  const auto objects = scene_file::objects_meant(robot.model(), setting.object, setting.property);
  const int count = ++parts.times_set[name];
  parts.simulation->at(parts.simulation->now() + some_cycles, [&parts, setting, entity, objects, writers, name, count] {
    if (parts.times_set[name] != count) return;  // set again meanwhile
    Entity& changed = parts.simulation->world().entity(entity);
    const auto is_there = [&](int object) {
      return ObjectAccess(changed, object).get(setting.property).numbers == setting.numbers;
    };
    if (std::ranges::all_of(objects, is_there)) return;
    parts.diagnostics.warn(name, fmt::format("what was set is gone: {} of {} writes '{}' ({})",
                                             fmt::join(writers, ", "), entity, setting.property, setting.where));
  });
}

}  // namespace

void apply(SceneParts& parts, const scene_file::PropertySetting& setting, const std::string& entity) {
  with_context(setting.where, [&] {
    Entity& changed = parts.simulation->world().entity(entity);
    for (const int object : scene_file::objects_meant(changed.model(), setting.object, setting.property)) {
      ObjectAccess(changed, object).set(setting.property, setting.numbers);
    }
    parts.simulation->record(to_text(setting, changed));
    watch(parts, setting, entity);
  });
}

void apply_settings(SceneParts& parts) {
  for (const scene_file::PropertySetting& setting : parts.spec.settings) {
    for (const std::string& name : setting.entities) {
      if (is_constant(setting)) {  // applied when the model was built
        parts.simulation->record(to_text(setting, parts.simulation->world().entity(name)));
      } else {
        apply(parts, setting, name);
      }
    }
  }
}

void apply_settings_of(SceneParts& parts, const Entity& entity) {
  for (const scene_file::PropertySetting& setting : parts.spec.settings) {
    if (is_constant(setting) || std::ranges::find(setting.entities, entity.name()) == setting.entities.end()) continue;
    apply(parts, setting, entity.name());
  }
}

}  // namespace murosimf::scene
