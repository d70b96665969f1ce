/// look.h - materials of field and surroundings, for every renderer: numbers of the patterns (look_patterns.h), the pile of the carpet,
/// and surfaces that are only looked at. OpenGL and the page for browsers take all of it from here.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "murosimf/model/shape.h"
#include "murosimf/render/light.h"

namespace murosimf::render {

inline constexpr Color thread{0.9, 0.9, 0.9};  ///< of nets

/// A number or a vector that the patterns read: one to four numbers.
struct LookNumber {
  const char* name;
  std::vector<double> values;
};

/// All of them for this light. `markings` may be null: there is no field.
[[nodiscard]] std::vector<LookNumber> look_numbers(const Light& light, const Markings* markings);

/// A corner of a surface: place [m] in the world, and where it is on the surface [m].
struct LookCorner {
  std::array<float, 3> place{};
  std::array<float, 2> at{};
};
struct LookSurface {
  std::vector<LookCorner> corners;
  std::vector<std::uint32_t> triangles;  ///< three corners each, counterclockwise seen from where people are
};

/// Half of the hall's floor [m].
struct HallSize {
  double half_length = 0, half_width = 0;
};
[[nodiscard]] HallSize hall_size(const Surroundings& surroundings, const Markings* markings);
/// The walls of a hall seen from inside; `at`: along, above the floor.
[[nodiscard]] LookSurface hall_walls(const Surroundings& surroundings, const Markings* markings);
/// Its ceiling from below; `at`: x and y.
[[nodiscard]] LookSurface hall_ceiling(const Surroundings& surroundings, const Markings* markings);

/// A net behind a goal. It hangs from the crossbar to the back and from there to the ground.
struct GoalNet {
  double side = 1;             ///< 1 for a goal at x > 0, -1 for one at x < 0
  double front = 0, rear = 0;  ///< [m] of the crossbar and of the back, from the middle of the field
  double half_width = 0;       ///< [m]
  double high = 0, low = 0;    ///< [m] above the ground
};
/// Nets as they hang; both sides are seen. `at`: along the goal, along the threads that go to the back.
[[nodiscard]] LookSurface hanging_nets(const std::vector<GoalNet>& nets);

/// Heights of a square of pile, 0 to 255 with a mean of 128, in rows of `pile_side`; it repeats.
inline constexpr int pile_side = 128;
inline constexpr double pile_texel = 0.004;  ///< [m]
[[nodiscard]] const std::vector<std::uint8_t>& pile();

}  // namespace murosimf::render
