#include "murosimf/scene/scene_pushing.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/dynamics/push.h"
#include "murosimf/scene_file/setting_targets.h"

namespace murosimf::scene {
namespace {

std::string in_brackets(const Vec3d& v) { return fmt::format("({:g}, {:g}, {:g})", v.x, v.y, v.z); }

std::string push_text(const std::string& target, const scene_file::PushSpec& push) {
  const std::string moment = norm(push.moment) > 0 ? fmt::format(", moment {} N m", in_brackets(push.moment)) : "";
  return fmt::format("push on {}: force {} N{}, until {:g} s", target, in_brackets(push.force), moment, push.end);
}

int pushed_object(const Model& model, const scene_file::PushSpec& push) {
  const int object = scene_file::objects_meant(model, push.object, "applied_force").front();
  const auto bodies = model.bodies();
  if (std::find(bodies.begin(), bodies.end(), object) != bodies.end()) return object;
  throw SetupError(fmt::format("'{}' has neither mass nor shape; push a body", model.objects()[object].name));
}

/// Level of the robot at that time, as far as the scene defines it.
std::string level_at(const scene_file::SceneSpec& spec, const Entity& entity, double time) {
  std::string level = entity.level;
  for (const scene_file::SceneEvent& event : spec.events) {
    const bool meant = std::find(event.entities.begin(), event.entities.end(), entity.name()) != event.entities.end();
    if (meant && !event.setting && event.key == "level" && event.time <= time) level = event.value;
  }
  return level;
}

/// Throws SetupError if that level ignores forces.
void check_feels(const Entity& entity, const std::string& level, std::string_view when) {
  if (find_entry(catalog::levels(), "level", level).traits.dynamic) return;
  std::vector<std::string_view> feeling;
  for (const catalog::LevelType& other : catalog::levels()) {
    if (other.traits.dynamic) feeling.push_back(other.name);
  }
  throw SetupError(fmt::format("'{}' is at {} {}, which ignores forces; it feels them at {}", entity.name(), level,
                               when, fmt::join(feeling, ", ")));
}

std::string name_of_pushed(const Entity& entity, int object, const scene_file::PushSpec& push) {
  const bool named = entity.model().find_object(push.object).has_value();
  return entity.name() + "." + (named ? push.object : entity.model().objects()[object].name);
}

using PushesOf = std::map<const Entity*, std::vector<dynamics::TimedPush>>;

/// Schedules a push of the spec.
void plan(SceneParts& parts, const scene_file::PushSpec& push, const std::string& name, PushesOf& all) {
  const Entity* entity = parts.simulation->world().find(name);
  if (!entity) throw SetupError(fmt::format("'{}' stands there for good; nothing pushes it", name));
  check_feels(*entity, level_at(parts.spec, *entity, push.begin), "then");
  const int object = pushed_object(entity->model(), push);
  all[entity].push_back({object, push.force, push.moment, from_seconds(push.begin), from_seconds(push.end)});
  const std::string text = push_text(name_of_pushed(*entity, object, push), push);
  parts.simulation->at(from_seconds(push.begin), [&parts, text] { parts.simulation->record(text); });
}

/// Adds entities that events of the spec push.
void expect_events(const SceneParts& parts, PushesOf& all) {
  for (const scene_file::SceneEvent& event : parts.spec.events) {
    if (!event.push) continue;
    for (const std::string& name : event.entities) {
      if (const Entity* entity = parts.simulation->world().find(name)) all[entity];
    }
  }
}

}  // namespace

void attach_pushes(SceneParts& parts, bool all_entities) {
  PushesOf all;
  for (const scene_file::PushSpec& push : parts.spec.pushes) {
    for (const std::string& name : push.entities) with_context(push.where, [&] { plan(parts, push, name, all); });
  }
  expect_events(parts, all);
  for (Entity* entity : parts.moving_entities) {  // the order of attaching must not depend on addresses
    if (all_entities || all.contains(entity)) {
      parts.pushes[entity] = &parts.simulation->attach<dynamics::Push>("push", *entity, parts.spec.rate, all[entity]);
    }
  }
}

void check_push(const SceneParts& parts, const scene_file::PushSpec& push, const std::string& name) {
  const Entity* entity = parts.simulation->world().find(name);
  if (!entity) throw SetupError(fmt::format("'{}' stands there for good; nothing pushes it", name));
  if (!parts.pushes.contains(entity)) {
    throw SetupError(fmt::format("'{}' cannot be pushed: the scene was built without pushes", name));
  }
  (void)pushed_object(entity->model(), push);
}

/// The level decides whether a push has any effect: it may have changed since the start.
void push(SceneParts& parts, const scene_file::PushSpec& push, const std::string& name) {
  check_push(parts, push, name);
  const Entity& entity = parts.simulation->world().entity(name);
  check_feels(entity, entity.level, "now");
  const int object = pushed_object(entity.model(), push);
  const Duration now = parts.simulation->now();
  scene_file::PushSpec from_now = push;
  from_now.end += seconds(now);
  parts.pushes.at(&entity)->add({object, push.force, push.moment, now, now + from_seconds(push.end)});
  parts.simulation->record(push_text(name_of_pushed(entity, object, push), from_now));
}

}  // namespace murosimf::scene
