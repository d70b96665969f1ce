/// drawn.h - all drawings for observers: by the software of robots (world/drawing.h), and by other programs
/// (debug_draw_source.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/world/world.h"

namespace murosimf::drawing {

/// Source name of drawings that are not by software of a robot.
inline constexpr std::string_view others_name = "roboviz";

/// Groups of one source.
struct Drawn {
  int entity = -1;  ///< index in the world; groups `of_robot` are in its frame; -1: no particular robot
  std::string by;   ///< its name, or others_name
  std::vector<DrawnGroup> groups;
};

/// Copies of the drawings of robots that are present. To be called between two steps.
[[nodiscard]] std::vector<Drawn> drawn_by_robots(const World& world);
/// A number that changes with the drawings of the same world. To be called between two steps.
[[nodiscard]] std::uint64_t drawn_changes(const World& world);

/// Teams of all entities; empty for entities without one.
[[nodiscard]] std::vector<std::string> teams_of(const World& world);

/// Drawings of other programs. `teams`: of the world's entities. Robots have their numbers in the order in which they were added;
/// the team of the first one is on the left.
[[nodiscard]] std::vector<Drawn> external_drawings(const ExternalDrawings& others, std::span<const std::string> teams);

/// A robot's team and its number in it, as in notes.
struct TeamPlace {
  int team = 0, number = 0;
  friend bool operator==(const TeamPlace&, const TeamPlace&) = default;
};
/// By entity; nothing for entities without a team.
[[nodiscard]] std::vector<std::optional<TeamPlace>> team_places(std::span<const std::string> teams);

}  // namespace murosimf::drawing
