/// drawn.h - all that is drawn for people who watch: by the software of robots (model/drawing.h), and by others (roboviz_drawings.h).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "murosimf/connect/roboviz_drawings.h"
#include "murosimf/model/world.h"

namespace murosimf::connect {

/// Groups of one who draws.
struct Drawn {
  int entity = -1;  ///< in the world, in whose frame groups `of_robot` are; -1: no robot in particular
  std::string by;   ///< its name, or "roboviz"
  std::vector<DrawnGroup> groups;
};

/// Copies of what robots draw who are there. Between two steps.
[[nodiscard]] std::vector<Drawn> drawn_by_robots(const World& world);
/// Another number if there is something new in the same world. Between two steps.
[[nodiscard]] std::uint64_t drawn_changes(const World& world);

/// `teams`: of the world's entities, empty for who has none. Robots have their numbers in the order in which they came into the world;
/// the team of the first one is on the left.
[[nodiscard]] std::vector<Drawn> drawn_by_others(const DrawnByOthers& others, std::span<const std::string> teams);

}  // namespace murosimf::connect
