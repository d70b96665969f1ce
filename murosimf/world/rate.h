/// rate.h - rate and instants of periodic events: number n at (n + phase) / hz, without drift.
#pragma once

#include <cmath>
#include <cstdint>

#include "murosimf/math/assert.h"
#include "murosimf/world/time.h"

namespace murosimf {

/// A periodic event. Its instants need not be multiples of a step: it happens in the step that begins nearest.
struct Rate {
  // NOLINTNEXTLINE(google-explicit-constructor): a rate alone is a number
  constexpr Rate(double rate_hz, double phase_of_period = 0) : hz(rate_hz), phase(phase_of_period) {}

  double hz;     ///< [Hz]
  double phase;  ///< [1] of a period, from 0 to below 1: time of the first event

  /// Between two instants, rounded to nanoseconds.
  [[nodiscard]] constexpr Duration period() const { return from_seconds(1 / hz); }
  /// Number n, from 0.
  [[nodiscard]] constexpr Duration instant(std::int64_t n) const {
    return from_seconds((static_cast<double>(n) + phase) / hz);
  }
  /// Whether the step of length `step` that begins at `now` is the one that begins nearest to an instant; of two steps that are
  /// equally near it is the later one.
  [[nodiscard]] bool falls_on(Duration now, Duration step) const {
    MUROSIMF_ASSERT(step > Duration{} && hz > 0);
    const std::int64_t nearest = std::llround(seconds(now) * hz - phase);
    for (std::int64_t n = nearest < 1 ? 0 : nearest - 1; n <= nearest; ++n) {
      const Duration late = now - instant(n);
      if (-step < 2 * late && 2 * late <= step) return true;
    }
    return false;
  }

  friend constexpr bool operator==(const Rate&, const Rate&) = default;
  friend constexpr auto operator<=>(const Rate&, const Rate&) = default;
};

}  // namespace murosimf
