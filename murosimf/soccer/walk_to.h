/// walk_to.h - the walking velocity towards a place.
#pragma once

#include <algorithm>
#include <cmath>

#include "murosimf/soccer/planar.h"

namespace murosimf::soccer {

/// [m/s, m/s, rad/s] for `walk_command`: turns to the place (x, y) [m], given in the robot's own frame, and walks the faster
/// the better it faces it, up to `speed` [m/s].
[[nodiscard]] inline Vec3d walk_to(const Vec3d& place, double speed) noexcept {
  constexpr double turning_gain = 1.5, fastest_turn = 0.7;  // [1/s], [rad/s]
  const double bearing = std::atan2(place.y, place.x), ahead = std::max(0.0, std::cos(bearing));
  return {speed * ahead * ahead, 0, std::clamp(turning_gain * bearing, -fastest_turn, fastest_turn)};
}

}  // namespace murosimf::soccer
