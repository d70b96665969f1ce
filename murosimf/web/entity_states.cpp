#include "murosimf/web/entity_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "murosimf/league/game_task.h"
#include "murosimf/soccer/beliefs.h"

namespace murosimf::web {
namespace {

using nlohmann::json;

constexpr std::size_t most_lines = 200;
constexpr std::array state_names = {"initial", "ready", "set", "playing", "finished"};

double rounded(double x) { return std::round(1e4 * x) / 1e4; }

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

json beliefs_of(const World& world) {
  json all = json::array();
  for (const auto& entity : world.entities()) {
    const auto pose = soccer::believed_pose(*entity);
    all.push_back(pose ? json{rounded(pose->x), rounded(pose->y), rounded(pose->z)} : json(nullptr));
  }
  return all;
}

/// The newest lines only: pages keep the older ones.
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

json game_of(const league::GameTask* game) {
  if (!game || game->words() == 0) return nullptr;
  const league::GameState& state = game->game();
  json teams = json::array();
  for (const std::size_t team : {0, 1}) {
    teams.push_back({{"name", game->team_name(team)}, {"score", game->team(team).score}});
  }
  // clamped: a referee of one's own may use other numbers
  const auto number = static_cast<std::size_t>(std::clamp<int>(state.state, 0, state_names.size() - 1));
  return {{"state", state_names[number]},
          {"half", state.first_half ? 1 : 2},
          {"remaining", state.seconds_left},
          {"teams", teams}};
}

}  // namespace murosimf::web
