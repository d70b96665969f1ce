#include "murosimf/web/entity_states.h"

#include <algorithm>
#include <array>
#include <string>

#include <nlohmann/json.hpp>

#include "murosimf/connect/game_view.h"

namespace murosimf::web {
namespace {

using nlohmann::json;

constexpr std::size_t most_lines = 200;
constexpr std::array state_names = {"initial", "ready", "set", "playing", "finished"};

/// The first robot of a team other than `not_of` that a referee has told something.
const Entity* told_robot(const World& world, const std::string& not_of) {
  for (const auto& entity : world.entities()) {
    if (entity->options().team.empty() || entity->options().team == not_of) continue;
    const Column<connect::GameView>* view = entity->find(connect::game_view);
    if (view && view->values[0].samples > 0) return entity.get();
  }
  return nullptr;
}

}  // namespace

json entity_states(const World& world) {
  json all = json::array();
  for (const auto& entity : world.entities()) {
    all.push_back({{"level", entity->level},
                   {"contact", entity->contact},
                   {"controller", entity->controller},
                   {"present", entity->present()},
                   {"frozen", entity->frozen()}});
  }
  return all;
}

json lines_of(const Simulation& simulation) {
  json lines = json::array();
  const auto& warnings = simulation.warnings();
  for (std::size_t i = warnings.size() - std::min(warnings.size(), most_lines); i < warnings.size(); ++i) {
    lines.push_back({{"time", 0.0}, {"text", warnings[i]}, {"warning", true}});
  }
  const auto& events = simulation.events();
  for (std::size_t i = events.size() - std::min(events.size(), most_lines); i < events.size(); ++i) {
    lines.push_back({{"time", seconds(events[i].time)}, {"text", events[i].text}, {"warning", false}});
  }
  return lines;
}

json game_of(const World& world) {
  const Entity* first = told_robot(world, "");
  if (!first) return nullptr;
  const Entity* other = told_robot(world, first->options().team);
  const connect::GameView& view = first->find(connect::game_view)->values[0];
  const auto state = static_cast<std::size_t>(std::clamp(view.state, 0.0, state_names.size() - 1.0));
  return {{"state", state_names[state]},
          {"half", view.half},
          {"remaining", view.remaining},
          {"teams",
           {{{"name", first->options().team}, {"score", view.score[0]}},
            {{"name", other ? other->options().team : "others"}, {"score", view.score[1]}}}}};
}

}  // namespace murosimf::web
