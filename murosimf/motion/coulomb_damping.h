/// coulomb_damping.h - Coulomb friction of a joint as a damper that follows its rate.
#pragma once

#include <algorithm>
#include <cmath>

namespace murosimf::motion {

/// b [N m s/rad | N s/m] of the friction -b qd that is F [N m | N] against the motion, and falls linearly to zero below
/// 0.05 rad/s (m/s). Taken at the beginning of a step, so a loaded joint creeps with that part of 0.05 rad/s that its load
/// is of F.
[[nodiscard]] inline double coulomb_damping(double friction, double rate) {
  constexpr double slow = 0.05;  // [rad/s | m/s]
  return friction / std::max(std::abs(rate), slow);
}

}  // namespace murosimf::motion
