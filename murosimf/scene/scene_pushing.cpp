#include "murosimf/scene/scene_pushing.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/motion/push.h"
#include "murosimf/scene_file/setting_targets.h"

namespace murosimf::scene {
namespace {

std::string in_brackets(const Vec3d& v) { return fmt::format("({:g}, {:g}, {:g})", v.x, v.y, v.z); }

std::string push_text(const std::string& whom, const scene_file::PushSpec& push) {
  const std::string moment = norm(push.moment) > 0 ? fmt::format(", moment {} N m", in_brackets(push.moment)) : "";
  return fmt::format("push on {}: force {} N{}, until {:g} s", whom, in_brackets(push.force), moment, push.end);
}

int pushed_object(const Model& model, const scene_file::PushSpec& push) {
  const int object = scene_file::objects_meant(model, push.object, "applied_force").front();
  const auto bodies = model.bodies();
  if (std::find(bodies.begin(), bodies.end(), object) != bodies.end()) return object;
  throw SetupError(fmt::format("'{}' has neither mass nor shape; push a body", model.objects()[object].name));
}

/// The level at which the robot will be then, as far as the scene says.
std::string level_at(const scene_file::SceneSpec& spec, const Entity& entity, double time) {
  std::string level = entity.level;
  for (const scene_file::SceneEvent& event : spec.events) {
    const bool meant = std::find(event.entities.begin(), event.entities.end(), entity.name()) != event.entities.end();
    if (meant && !event.setting && event.key == "level" && event.time <= time) level = event.value;
  }
  return level;
}

/// Throws SetupError if its level ignores forces when the push begins.
void check_feels(const scene_file::SceneSpec& spec, const Entity& entity, const scene_file::PushSpec& push) {
  const std::string level = level_at(spec, entity, push.begin);
  if (find_entry(catalog::levels(), "level", level).traits.dynamic) return;
  std::vector<std::string_view> feeling;
  for (const catalog::LevelType& other : catalog::levels()) {
    if (other.traits.dynamic) feeling.push_back(other.name);
  }
  throw SetupError(fmt::format("'{}' is at {} then, which ignores forces; it feels them at {}", entity.name(), level,
                               fmt::join(feeling, ", ")));
}

}  // namespace

void attach_pushes(SceneParts& parts) {
  std::map<Entity*, std::vector<motion::TimedPush>> all;
  for (const scene_file::PushSpec& push : parts.spec.pushes) {
    for (const std::string& name : push.entities)
      with_context(push.where, [&] {
        Entity* entity = parts.simulation->world().find(name);
        if (!entity) throw SetupError(fmt::format("'{}' stands there for good; nothing pushes it", name));
        check_feels(parts.spec, *entity, push);
        const int object = pushed_object(entity->model(), push);
        all[entity].push_back({object, push.force, push.moment, from_seconds(push.begin), from_seconds(push.end)});
        const bool named = entity->model().find_object(push.object).has_value();
        const std::string text =
            push_text(name + "." + (named ? push.object : entity->model().objects()[object].name), push);
        parts.simulation->at(from_seconds(push.begin), [&parts, text] { parts.simulation->record(text); });
      });
  }
  for (Entity* moving_entity : parts.moving_entities) {  // a map of addresses has no order that could be repeated
    if (all.contains(moving_entity))
      parts.simulation->attach<motion::Push>("push", *moving_entity, parts.spec.rate, all[moving_entity]);
  }
}

}  // namespace murosimf::scene
