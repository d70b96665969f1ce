/// servo_counts.h - angles as the encoder of a servo counts them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "murosimf/connect/dynamixel/control_table.h"

namespace murosimf::connect::dynamixel {

inline constexpr double pulses_per_radian = pulses_per_turn / (2 * std::numbers::pi);

inline double pulses_of(double angle) { return middle_pulse + angle * pulses_per_radian; }
inline double angle_of(double pulses) { return (pulses - middle_pulse) / pulses_per_radian; }

/// For a register; 0 for what is not finite.
inline std::int32_t rounded(double value) {
  constexpr double most = 1 << 30;
  return std::isfinite(value) ? static_cast<std::int32_t>(std::lround(std::clamp(value, -most, most))) : 0;
}

// Velocities and loads of protocol 1.0 have a direction beside their size.
inline constexpr std::int32_t clockwise_bit = 0x400, largest_size = 0x3FF;

}  // namespace murosimf::connect::dynamixel
