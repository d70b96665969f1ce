#include "murosimf/geometry/gjk.h"

#include <algorithm>
#include <cmath>

#include "murosimf/geometry/gjk_simplex.h"

namespace murosimf::geometry {
namespace {

constexpr int most_steps = 128;
constexpr double converged = 1e-12;  // relative, of the squared distance: directions are good to 3e-7
constexpr double rounding = 1e-15;   // relative, of the product of gap and size
constexpr double touching = 1e-30;   // relative, of the squared distance: below is overlap

DifferencePoint farthest(const Body& a, const Vec3d& shift, const Body& b, const Vec3d& against) {
  const Vec3d on_a = a.core_support(-against) + shift, on_b = b.core_support(against);
  return {on_a - on_b, on_a, on_b};
}

CoreGap gap_of(const GjkSimplex& simplex, double square) {
  return {simplex.on_a(), simplex.on_b(), simplex.nearest(), std::sqrt(square)};
}

}  // namespace

CoreGap gap_of_cores(const Body& a, const Vec3d& shift, const Body& b, const Vec3d& guess, double enough) {
  GjkSimplex simplex;
  const DifferencePoint first = farthest(a, shift, b, guess);
  simplex.add(first);
  Vec3d v = first.w;
  double square = dot(v, v), scale = square;
  bool apart = false;
  for (int step = 0; step < most_steps; ++step) {
    if (!(square > touching * scale)) return {};
    const DifferencePoint next = farthest(a, shift, b, v);
    const double reached = dot(v, next.w);
    if (reached > 0 && reached * reached > enough * enough * square) return {{}, {}, {}, reached / std::sqrt(square)};
    if (square - reached <= converged * square + rounding * std::sqrt(scale * square) || simplex.has(next.w)) break;
    scale = std::max(scale, dot(next.w, next.w));
    GjkSimplex larger = simplex;
    const bool inside = larger.add(next);
    apart = apart || reached > 0;
    if (inside && apart) break;  // a flat tetrahedron, and rounding
    if (inside) return {};
    v = larger.nearest();
    const double now = dot(v, v);
    if (!(now < square)) break;  // as good as numbers go
    simplex = larger;
    square = now;
  }
  return gap_of(simplex, square);
}

}  // namespace murosimf::geometry
