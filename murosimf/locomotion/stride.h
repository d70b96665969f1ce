/// stride.h - place of one foot of a periodic gait along its stride.
///
/// Phase p in [-pi, 2 pi) of the foot; d: half of the time in which both feet of a pair stand together.
///     swing (d < p < pi - d), u = (p - d)/(pi - 2 d):   xi = -cos(pi u)/2      lift = (1 - cos 2 pi u)/2
///     stance:                                           xi runs linearly from +1/2 to -1/2, lift = 0
#pragma once

#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::locomotion {

struct Stride {
  double xi = 0;    ///< [1] place along the stride, +1/2 front, -1/2 back
  double lift = 0;  ///< [1] 0 on the ground, 1 at the top
};

[[nodiscard]] inline Stride stride(double p, double d) noexcept {
  if (p < 0) p += 2 * pi;
  MUROSIMF_ASSERT(2 * d < pi);
  if (p > d && p < pi - d) {
    const double u = (p - d) / (pi - 2 * d);
    return {-0.5 * std::cos(pi * u), 0.5 * (1 - std::cos(2 * pi * u))};
  }
  double since_landing = p - (pi - d);
  if (since_landing < 0) since_landing += 2 * pi;
  return {0.5 - since_landing / (pi + 2 * d), 0};
}

}  // namespace murosimf::locomotion
