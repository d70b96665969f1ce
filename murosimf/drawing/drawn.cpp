#include "murosimf/drawing/drawn.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::drawing {
namespace {

constexpr double above_base = 0.35;  // [m] notes at robots
constexpr double note_height = 0.1;  // [m]

const Drawings* drawings_of(const Entity& entity) {
  const Column<Drawings>* drawn = entity.find(properties::drawings);
  return drawn && !drawn->values.empty() ? drawn->values.data() : nullptr;
}

/// Adds drawings to the hash. The count of changes is restored with a state; then other drawings may have the same count.
void add_to(Hasher& hasher, const Drawings& drawings) {
  hasher.add(drawings.changes);
  for (const DrawnGroup& group : drawings.groups) {
    hasher.add(static_cast<std::uint64_t>(group.time.count()));
    for (const DrawnShape& shape : group.shapes) {
      for (const Vec3d& point : shape.points) {
        hasher.add(point.x);
        hasher.add(point.y);
        hasher.add(point.z);
      }
    }
  }
}

}  // namespace

std::vector<Drawn> drawn_by_robots(const World& world) {
  std::vector<Drawn> all;
  for (std::size_t i = 0; i < world.entities().size(); ++i) {
    const Entity& entity = *world.entities()[i];
    const Drawings* drawings = drawings_of(entity);
    if (drawings && !drawings->groups.empty() && entity.present())
      all.push_back({static_cast<int>(i), entity.name(), drawings->groups});
  }
  return all;
}

std::uint64_t drawn_changes(const World& world) {
  Hasher hasher;
  for (const auto& entity : world.entities()) {
    const Drawings* drawings = drawings_of(*entity);
    if (drawings) add_to(hasher, *drawings);
    hasher.add(static_cast<std::uint64_t>(entity->present() ? 1 : 0));
  }
  return hasher.value();
}

std::vector<std::string> teams_of(const World& world) {
  std::vector<std::string> teams;
  for (const auto& entity : world.entities()) teams.push_back(entity->options().team);
  return teams;
}

std::vector<std::optional<TeamPlace>> team_places(std::span<const std::string> teams) {
  std::vector<std::string_view> names;  // of teams; `members`: number of robots so far
  std::vector<int> members;
  std::vector<std::optional<TeamPlace>> places;
  for (const std::string& team : teams) {
    if (team.empty()) {
      places.emplace_back();
      continue;
    }
    const auto number = static_cast<std::size_t>(std::ranges::find(names, team) - names.begin());
    // Teams are numbered in the order of their first robots.
    if (number == names.size()) {
      names.push_back(team);
      members.push_back(0);
    }
    MUROSIMF_ASSERT(names.size() == members.size() && number < names.size());
    places.push_back(TeamPlace{static_cast<int>(number), members[number]++});
  }
  MUROSIMF_ASSERT(places.size() == teams.size());
  return places;
}

std::vector<Drawn> external_drawings(const ExternalDrawings& others, std::span<const std::string> teams) {
  std::vector<Drawn> all;
  if (!others.groups.empty()) all.push_back({-1, std::string(others_name), others.groups});
  const std::vector<std::optional<TeamPlace>> places = team_places(teams);
  for (const ExternalDrawings::Note& note : others.notes) {
    // Notes for robots that do not exist are ignored.
    const auto place = std::ranges::find(places, TeamPlace{note.team, note.number});
    if (place == places.end()) continue;
    const auto entity = static_cast<int>(place - places.begin());
    DrawnShape text{.kind = DrawnShape::text, .points = {{0, 0, above_base}}, .size = note_height, .color = note.color};
    text.words = note.text;
    DrawnGroup group{.name = "annotation", .of_robot = true};
    group.shapes.push_back(std::move(text));
    all.push_back({entity, std::string(others_name), {std::move(group)}});
  }
  return all;
}

}  // namespace murosimf::drawing
