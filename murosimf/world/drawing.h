/// drawing.h - debug drawing of control software: named groups of shapes. No computation uses it, and no state depends
/// on it.
///
///     const Column<Drawings>* drawn = robot.find(properties::drawings);      // null: its software cannot draw
///     for (const DrawnGroup& group : drawn->values[0].groups) ...
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/math/vec3.h"
#include "murosimf/model/property.h"
#include "murosimf/model/shape.h"
#include "murosimf/model/value.h"
#include "murosimf/world/state_archive.h"
#include "murosimf/world/time.h"

namespace murosimf {

struct DrawnShape {
  enum Kind : std::uint32_t {
    circle,   ///< around the first point, flat: normal to z of the frame
    line,     ///< through all points
    dots,     ///< at each point
    sphere,   ///< around the first point
    polygon,  ///< filled; points on its border
    text      ///< at the first point
  };
  static constexpr std::uint32_t kinds = 6;

  Kind kind = circle;
  std::vector<Vec3d> points{};
  double size = 0;  ///< [m] radius, width of lines and dots, height of texts; 0: as small as can be seen
  Color color{1, 1, 1};
  double opacity = 1;   ///< from 0 to 1
  std::string words{};  ///< of a text

  void state(StateArchive& archive) { archive(kind, points, size, color.red, color.green, color.blue, opacity, words); }

  friend bool operator==(const DrawnShape& a, const DrawnShape& b) {
    const auto same = [](const Vec3d& p, const Vec3d& q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
    return a.kind == b.kind && a.size == b.size && a.color == b.color && a.opacity == b.opacity && a.words == b.words &&
           std::ranges::equal(a.points, b.points, same);
  }
};

/// What files and messages call them, by kind.
inline constexpr std::array<std::string_view, DrawnShape::kinds> drawn_kind_names{"circle", "line",    "dots",
                                                                                  "sphere", "polygon", "text"};

struct DrawnGroup {
  std::string name;       ///< unique; a new group of this name replaces the old one
  bool of_robot = false;  ///< points are in the frame of its base and move with it; otherwise in the world
  Duration time{};        ///< simulated, when it was drawn
  std::vector<DrawnShape> shapes{};

  void state(StateArchive& archive) { archive(name, of_robot, time, shapes); }
  friend bool operator==(const DrawnGroup&, const DrawnGroup&) = default;
};

/// Of one robot.
struct Drawings {
  std::vector<DrawnGroup> groups;  ///< in the order of their names
  std::uint64_t changes = 0;       ///< counter by which observers notice changes

  void state(StateArchive& archive) { archive(groups, changes); }
};

inline void append_hash(Hasher& hasher, const Drawings& drawings) { hasher.add(drawings.changes); }
inline void state(StateArchive& archive, Drawings& drawings) { archive(drawings.groups, drawings.changes); }

namespace properties {

inline constexpr Property<Drawings> drawings{
    {"drawings", "-", "-", "debug drawings of the robot's control software", Scope::sensor}};

}  // namespace properties
}  // namespace murosimf
