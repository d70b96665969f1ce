/// time.h - simulated time is an integer number of nanoseconds.
#pragma once

#include <chrono>

namespace murosimf {

using Duration = std::chrono::nanoseconds;

// Range of all periodic rates [Hz]; others are errors of users.
constexpr double slowest_rate = 1e-3;
constexpr double fastest_rate = 1e5;
constexpr double usual_step_rate = 1000;  ///< [Hz] of motion and contact, where a scene does not say

[[nodiscard]] constexpr double seconds(Duration duration) { return static_cast<double>(duration.count()) * 1e-9; }

/// Nearest whole number of nanoseconds.
[[nodiscard]] constexpr Duration from_seconds(double s) {
  return Duration(static_cast<Duration::rep>(s * 1e9 + (s < 0 ? -0.5 : 0.5)));
}

}  // namespace murosimf
