/// drawn.h - all that is drawn for people who watch: by the software of robots (model/drawing.h), and by others
/// (debug_draw_source.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/model/world.h"

namespace murosimf::drawing {

/// Who draws, of all that is no software of a robot.
inline constexpr std::string_view others_name = "roboviz";

/// Groups of one who draws.
struct Drawn {
  int entity = -1;  ///< in the world, in whose frame groups `of_robot` are; -1: no robot in particular
  std::string by;   ///< its name, or others_name
  std::vector<DrawnGroup> groups;
};

/// Copies of what robots draw who are there. Between two steps.
[[nodiscard]] std::vector<Drawn> drawn_by_robots(const World& world);
/// Another number if there is something new in the same world. Between two steps.
[[nodiscard]] std::uint64_t drawn_changes(const World& world);

/// Of all entities, empty for who has none.
[[nodiscard]] std::vector<std::string> teams_of(const World& world);

/// `teams`: of the world's entities. Robots have their numbers in the order in which they came into the world;
/// the team of the first one is on the left.
[[nodiscard]] std::vector<Drawn> external_drawings(const ExternalDrawings& others, std::span<const std::string> teams);

/// A robot's team and its number there, as notes have them.
struct TeamPlace {
  int team = 0, number = 0;
  friend bool operator==(const TeamPlace&, const TeamPlace&) = default;
};
/// By entity; nothing: it has no team.
[[nodiscard]] std::vector<std::optional<TeamPlace>> team_places(std::span<const std::string> teams);

}  // namespace murosimf::drawing
