/// gjk.h - closest points of two convex bodies by their support functions.
///
/// Source: E. G. Gilbert, D. W. Johnson and S. S. Keerthi, A fast procedure for computing the distance between complex
/// objects in three-dimensional space, 1988.
#pragma once

#include <limits>

#include "murosimf/geometry/support.h"

namespace murosimf::geometry {

/// Closest points of two cores; world frame.
struct CoreGap {
  Vec3d on_a, on_b;     ///< [m]
  Vec3d way;            ///< [m] from the one on B to that on A
  double distance = 0;  ///< [m]; zero if the cores overlap, and then the points have no meaning

  /// Unit, from B to A; only if the distance is not zero.
  [[nodiscard]] Vec3d direction() const { return (1 / distance) * way; }
};

/// Gap between the core of A, moved by `shift` [m], and that of B. `guess`: about from B to A, any length but zero. A gap
/// larger than `enough` [m] is not looked at closely: then distance is some number above `enough`.
[[nodiscard]] CoreGap gap_of_cores(const Body& a, const Vec3d& shift, const Body& b, const Vec3d& guess,
                                   double enough = std::numeric_limits<double>::infinity());

}  // namespace murosimf::geometry
