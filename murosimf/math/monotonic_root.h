/// monotonic_root.h - solves f(x) = target for an increasing function: Newton's method, kept in a bracket.
#pragma once

#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf {

/// A function and its derivative at one place.
struct Slope {
  double value, slope;
};

/// The x in [low, high] with f(x).value = target, for f that increases there and f(low) <= target <= f(high).
/// A step of Newton that would leave the bracket becomes a bisection, so it always converges. It ends with a step of
/// less than `tolerance` (1 + |x|).
template <class F>
double monotonic_root(const F& f, double target, double low, double high, double guess,
                      double tolerance = 1e-15) noexcept {
  MUROSIMF_ASSERT(low <= high && tolerance > 0);
  double x = guess > low && guess < high ? guess : 0.5 * (low + high);
  for (int i = 0; i < 200; ++i) {
    const auto [value, slope] = f(x);
    (value < target ? low : high) = x;
    double next = x + (target - value) / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    const double step = std::fabs(next - x);
    x = next;
    if (step <= tolerance * (1 + std::fabs(x))) break;
  }
  return x;
}

}  // namespace murosimf
