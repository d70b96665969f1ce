#include "murosimf/geometry/descent.h"

#include <cmath>

#include "murosimf/geometry/gjk.h"

namespace murosimf::geometry {
namespace {

constexpr int most_steps = 60;

}  // namespace

double Descent::shift(const Vec3d& n) const { return dot(n, b_.core_support(n) - a_.core_support(-n)); }

Deepest Descent::from(const Vec3d& n) const {
  Deepest best;
  best.penetration = {n, shift(n)};
  Vec3d last_way;
  for (int i = 0; i < most_steps; ++i) {
    const double before = best.penetration.depth;
    const Vec3d out = (before + step_out_) * best.penetration.normal;
    const CoreGap gap = gap_of_cores(a_, out, b_, best.penetration.normal);
    if (!(gap.distance > 0)) break;
    best.on_a = gap.on_a - out;
    best.on_b = gap.on_b;
    const Vec3d next = gap.direction();
    const Vec3d way = next - best.penetration.normal;
    take_if_lower(next, best);
    leap(next, way, last_way, best);
    last_way = way;
    if (!(before - best.penetration.depth > 1e-9 * step_out_)) break;
  }
  put_points(best);
  return best;
}

/// Where the last gap does not belong to the normal (the minimum is flat, and rounding chose), the farthest points do: of
/// a smooth body they are unique.
void Descent::put_points(Deepest& deepest) const {
  const auto& [n, depth] = deepest.penetration;
  const Vec3d aside = tangential(deepest.on_b - deepest.on_a, n);
  const double error = norm(aside) + std::abs(dot(deepest.on_b - deepest.on_a, n) - depth);
  if (error < 0.01 * step_out_) return;
  if (std::holds_alternative<Ellipsoid>(a_.shape())) {
    deepest.on_a = a_.core_support(-n);
    deepest.on_b = deepest.on_a + depth * n;
  } else {
    deepest.on_b = b_.core_support(n);
    deepest.on_a = deepest.on_b - depth * n;
  }
}

void Descent::take_if_lower(const Vec3d& n, Deepest& best) const {
  const double here = shift(n);
  if (here < best.penetration.depth) best.penetration = {n, here};
}

/// Steps shrink by about the same factor each time: sum up the rest of them.
void Descent::leap(const Vec3d& next, const Vec3d& way, const Vec3d& last_way, Deepest& best) const {
  const double square = dot(last_way, last_way);
  if (!(square > 0)) return;
  const double factor = dot(way, last_way) / square;
  if (!(factor > 0.05 && factor < 0.99)) return;
  const Vec3d far = next + factor / (1 - factor) * way;
  take_if_lower((1 / norm(far)) * far, best);
}

}  // namespace murosimf::geometry
