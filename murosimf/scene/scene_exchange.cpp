// How a scene changes while it runs: levels, laws and properties, by name.
#include <algorithm>

#include <fmt/format.h>

#include "murosimf/motion/servo_law.h"
#include "murosimf/motion/torque_watch.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/property_checks.h"
#include "murosimf/scene/registry.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/setting_targets.h"

namespace murosimf::scene {

void Scene::schedule_events() {
  const SceneSpec& spec = spec_;
  for (const SceneEvent& event : spec.events) {
    for (const std::string& entity : event.entities) {
      if (event.setting) {
        with_context(event.where, [&] {
          if (is_constant(*event.setting)) {
            throw SetupError(
                fmt::format("'{}' is a constant of the model; set it before the run, by --set", event.key));
          }
          const Model& model = simulation_->world().entity(entity).model();
          (void)objects_meant(model, event.setting->object, event.setting->property);
        });
      }
      // a call for everybody: one who refuses does not keep the others from changing
      simulation_->at(from_seconds(event.time), [this, &event, &entity] { apply(event, entity); });
    }
  }
}

void Scene::apply(const SceneEvent& event, const std::string& entity) {
  with_context(event.where, [&] {
    if (event.setting) return apply(*event.setting, entity);
    if (event.key == "level") return exchange_level(entity, event.value);
    if (event.key == "contact") return exchange_contact(entity, event.value);
    exchange_servo_law(entity, event.value);
  });
}

void Scene::apply(const PropertySetting& setting, const std::string& entity) {
  with_context(setting.where, [&] {
    Entity& changed = simulation_->world().entity(entity);
    for (const int object : objects_meant(changed.model(), setting.object, setting.property)) {
      ObjectAccess(changed, object).set(setting.property, setting.numbers);
    }
    simulation_->record(to_text(setting, changed));
    watch(setting, entity);
  });
}

RobotSpec& Scene::spec_of(std::string_view robot) {
  std::vector<std::string_view> names;
  for (RobotSpec& spec : spec_.robots) {
    if (spec.name == robot) return spec;
    names.push_back(spec.name);
  }
  throw SetupError(unknown_name("robot", robot, names));
}

void Scene::renew_level(const RobotSpec& robot) {
  Entity& entity = simulation_->world().entity(robot.name);
  const LevelType& level = find_entry(levels(), "level", robot.level);
  const LevelOptions options = level_options(robot);
  const std::string overload = motion::overload_message(entity);  // the level that goes takes it along
  simulation_->exchange(robot.level, entity, [&](Setup& setup) { return level.make(setup, options); });
  if (!overload.empty()) warnings_.push_back(overload);
  entity.contact = level.dynamic ? robot.contact : "";
  warn_about(robot, entity.model());
  note_about_sensors(robot);
}

void Scene::exchange_level(std::string_view robot, std::string_view level) {
  RobotSpec& spec = spec_of(robot);
  RobotSpec changed = spec;
  changed.level = find_entry(levels(), "level", level).name;
  renew_level(changed);
  if (changed.level == spec.level) simulation_->record(fmt::format("{}: {}, as before", robot, level));
  spec = std::move(changed);
}

void Scene::exchange_servo_law(std::string_view robot, std::string_view law) {
  RobotSpec& spec = spec_of(robot);
  RobotSpec changed = spec;
  changed.servo_law = find_entry(motion::servo_laws(), "servo law", law).name;
  if (spec.level == "articulated_dynamics") renew_level(changed);
  simulation_->record(fmt::format("{}: servo law {}", robot, law));
  spec = std::move(changed);
}

void Scene::exchange_contact(std::string_view entity, std::string_view law) {
  const ContactLawType& contact = find_entry(contacts(), "contact law", law);
  const auto moving_entity =
      std::find(moving_entities_.begin(), moving_entities_.end(), &simulation_->world().entity(entity));
  if (moving_entity == moving_entities_.end())
    throw SetupError(fmt::format("'{}' does not move; it has no contact law", entity));
  ground_contacts_[static_cast<std::size_t>(moving_entity - moving_entities_.begin())]->exchange_law(contact.make());
  simulation_->record(fmt::format("{}: contact {}", entity, law));
  if (*moving_entity == ball_) {
    ball_->contact = spec_.ball->contact = law;
    return;
  }
  if (std::find(bodies_.begin(), bodies_.end(), *moving_entity) != bodies_.end()) {
    (*moving_entity)->contact = law;
    return;
  }
  RobotSpec& robot = spec_of(entity);
  robot.contact = law;
  if (find_entry(levels(), "level", robot.level).dynamic) (*moving_entity)->contact = law;
  warn_about(robot, (*moving_entity)->model());
}

}  // namespace murosimf::scene
