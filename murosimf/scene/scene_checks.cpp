// What a scene sets: whether it acts, is impossible, or changes nothing. docs/scenes.md has the rule.
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/property_checks.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/setting_targets.h"
#include "murosimf/scene/start_overlaps.h"
#include "murosimf/scene/unused_settings.h"

namespace murosimf::scene {
namespace {

void add_materials(const Model& model, std::set<std::string>& names) {
  for (const int object : model.having(properties::shapes)) {
    for (const PlacedShape& placed : *model.find(properties::shapes, object)) {
      if (!placed.surface.material.empty()) names.insert(placed.surface.material);
    }
  }
}

}  // namespace

void Scene::warn_about_settings() {
  const auto add = [&](const std::vector<std::string>& lines) {
    warnings_.insert(warnings_.end(), lines.begin(), lines.end());
  };
  add(unused_keys(spec_));
  std::set<std::string> materials;
  add_materials(field_->model(), materials);
  for (const Entity* moving_entity : moving_entities_) add_materials(moving_entity->model(), materials);
  const std::vector<std::string> used(materials.begin(), materials.end());
  add(unused_pairs(spec_, used));
  if (auto line = unused_friction_direction(spec_, used); !line.empty()) warnings_.push_back(std::move(line));
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotSpec& robot = spec_.robots[i];
    check_no_contact(robot, robots_[i]->model());
    if (const auto line = check_command(robot, robots_[i]->model(), robot.command); !line.empty()) warn(robot, line);
  }
}

void Scene::check_no_contact(const RobotSpec& robot, const Model& model) {
  const auto given = robot.given.find("no_contact");
  if (given == robot.given.end()) return;
  for (const auto& [a, b] : robot.collision.never) {
    for (const std::string& name : {a, b}) {
      if (model.find_object(name)) continue;
      throw SetupError(fmt::format("{}: model '{}': {}", given->second.where, model.name(),
                                   unknown_name("object", name, model.object_names())));
    }
  }
  if (!robot.collision.never.empty() && !robot.collision.self_collision) {
    warn(robot, "'no_contact' changes nothing without 'self_collision = true'");
  }
}

void Scene::check_property(const PropertySetting& setting, double time) {
  for (const std::string& entity : setting.entities) {
    with_context(setting.where, [&] {
      if (const auto line = check_setting(*simulation_, spec_, setting, entity, time); !line.empty()) {
        warnings_.push_back(fmt::format("{}: {}; it changes nothing ({})", entity, line, setting.where));
      }
    });
    if (setting.property != properties::walk_command.name || setting.numbers.size() != 3) continue;
    const Vec3d command{setting.numbers[0], setting.numbers[1], setting.numbers[2]};
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (spec_.robots[i].name != entity) continue;
      const auto line = check_command(spec_.robots[i], robots_[i]->model(), command);
      if (!line.empty()) warn(spec_.robots[i], fmt::format("{} ({})", line, setting.where));
    }
  }
}

void Scene::check_properties() {
  for (const PropertySetting& setting : spec_.settings) {
    if (!is_constant(setting)) check_property(setting, 0);  // constants were checked with the model
  }
  for (const SceneEvent& event : spec_.events) {
    if (event.setting) check_property(*event.setting, event.time);
  }
}

void Scene::warn_about_start() {
  const auto lines = start_overlaps(*field_, moving_entities_);
  warnings_.insert(warnings_.end(), lines.begin(), lines.end());
}

std::string Scene::events_to_come() const {
  const Duration now = simulation_->now();
  if (now == Duration{}) return {};
  std::vector<std::pair<double, const std::string*>> late;  // [s], and where it is written
  const auto look_at = [&](double time, const std::string& where) {
    if (from_seconds(time) > now - simulation_->tick()) late.emplace_back(time, &where);
  };
  for (const SceneEvent& event : spec_.events) look_at(event.time, event.where);
  for (const PushSpec& push : spec_.pushes) look_at(push.begin, push.where);
  if (late.empty()) return {};
  const auto& [time, where] = *std::ranges::min_element(late, {}, [](const auto& one) { return one.first; });
  return fmt::format("the run ended at {:.3f} s: {} of {} {} did not come, the first at {:.3f} s ({})", seconds(now),
                     late.size(), spec_.events.size() + spec_.pushes.size(),
                     spec_.pushes.empty() ? "events" : "events and pushes", time, *where);
}

void Scene::watch(const PropertySetting& setting, const std::string& entity) {
  constexpr Duration some_cycles = std::chrono::milliseconds(50);  // of any controller
  const Entity& robot = simulation_->world().entity(entity);
  const bool target =
      setting.property == properties::joint_target.name || setting.property == properties::joint_velocity_target.name;
  const auto writers = simulation_->writers_of(robot, setting.property);
  if (!target || writers.empty()) return;
  const std::string name = setting_path(setting, robot);
  const auto objects = objects_meant(robot.model(), setting.object, setting.property);
  const int count = ++settings_[name];
  simulation_->at(simulation_->now() + some_cycles, [this, setting, entity, objects, writers, name, count] {
    if (settings_[name] != count) return;  // set anew meanwhile
    Entity& changed = simulation_->world().entity(entity);
    const auto is_there = [&](int object) {
      return ObjectAccess(changed, object).get(setting.property).numbers == setting.numbers;
    };
    if (std::ranges::all_of(objects, is_there)) return;
    warnings_.push_back(fmt::format("{}: what was set is gone: {} of {} writes '{}' ({})", name,
                                    fmt::join(writers, ", "), entity, setting.property, setting.where));
  });
}

}  // namespace murosimf::scene
