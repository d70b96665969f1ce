/// descent.h - the least shift that parts two overlapping bodies, from a start nearby.
///
/// The least shift along n that parts A from B is g(n) = h_B(n) + h_A(-n), with h the support functions. Shift A out along
/// n, a little more than g(n), and take the direction of the gap as the next n. With p the shifted origin, gap e and next
/// direction m: g(m) = p . m - e <= |p| - e <= g(n), so g never rises; n stays where g has a local minimum.
#pragma once

#include "murosimf/geometry/penetration.h"

namespace murosimf::geometry {

/// Of the cores of two bodies: margins are left out.
class Descent {
 public:
  /// size [m] of the smaller body.
  Descent(const Body& a, const Body& b, double size) : a_(a), b_(b), step_out_(1e-3 * size) {}

  /// The local minimum below the unit vector n.
  [[nodiscard]] Deepest from(const Vec3d& n) const;

 private:
  [[nodiscard]] double shift(const Vec3d& n) const;
  void take_if_lower(const Vec3d& n, Deepest& best) const;
  void put_points(Deepest& deepest) const;
  void leap(const Vec3d& next, const Vec3d& way, const Vec3d& last_way, Deepest& best) const;

  const Body &a_, &b_;
  double step_out_;  // [m]
};

}  // namespace murosimf::geometry
