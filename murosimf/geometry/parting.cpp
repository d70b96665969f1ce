// The least shift is the least value over all unit vectors n of g(n) = h_B(n) + h_A(-n), with h the support functions. EPA
// (G. van den Bergen, Proximity queries and penetration depth computation on 3D game objects, 2001; libccd) finds the
// whole sphere's lowest place, exactly for polyhedra and roughly for curved bodies. There g is lowered further: shift A
// out along n, a little more than g(n), and take the direction of the gap as the next n. With p the shifted origin, gap
// e and next direction m: g(m) = p . m - e <= |p| - e <= g(n), so it never rises; it stays where n is a local minimum.
#include "murosimf/geometry/parting.h"

#include <algorithm>
#include <cmath>

#include "murosimf/geometry/epa.h"
#include "murosimf/geometry/gjk.h"

namespace murosimf::geometry {
namespace {

constexpr int most_steps = 60;
constexpr double tolerance = 1e-5;  // of EPA, in sizes of the smaller body

double size_of(const Body& a, const Body& b) {
  return std::min(bounding_radius(a.shape()), bounding_radius(b.shape()));
}

/// Lowers g from a start.
class Descent {
 public:
  Descent(const Body& a, const Body& b) : a_(a), b_(b), step_out_(1e-3 * size_of(a, b)) {}

  /// Least shift of the cores along unit n.
  [[nodiscard]] double shift(const Vec3d& n) const { return dot(n, b_.core_support(n) - a_.core_support(-n)); }

  /// Goes down from unit n; the result's margins are still those of the cores.
  [[nodiscard]] Deepest from(Vec3d n) const {
    Deepest best;
    best.parting = {n, shift(n)};
    Vec3d last_way;
    for (int i = 0; i < most_steps; ++i) {
      const Vec3d out = (best.parting.depth + step_out_) * best.parting.normal;
      const CoreGap gap = gap_of_cores(a_, out, b_, best.parting.normal);
      if (!(gap.distance > 0)) break;
      best.on_a = gap.on_a - out;
      best.on_b = gap.on_b;
      const Vec3d next = gap.direction();
      const Vec3d way = next - best.parting.normal;
      const double before = best.parting.depth;
      take_if_lower(next, best);
      leap(next, way, last_way, best);
      last_way = way;
      if (!(before - best.parting.depth > 1e-12 * step_out_)) break;
    }
    return best;
  }

 private:
  void take_if_lower(const Vec3d& n, Deepest& best) const {
    const double here = shift(n);
    if (here < best.parting.depth) best.parting = {n, here};
  }
  /// Steps shrink by about the same factor each time: sum up the rest of them.
  void leap(const Vec3d& next, const Vec3d& way, const Vec3d& last_way, Deepest& best) const {
    const double square = dot(last_way, last_way);
    if (!(square > 0)) return;
    const double factor = dot(way, last_way) / square;
    if (!(factor > 0.05 && factor < 0.99)) return;
    const Vec3d far = next + factor / (1 - factor) * way;
    take_if_lower((1 / norm(far)) * far, best);
  }

  const Body &a_, &b_;
  double step_out_;  // [m]
};

void add_margins(double margin_a, double margin_b, Deepest& deepest) {
  Parting& parting = deepest.parting;
  parting.depth += margin_a + margin_b;
  deepest.on_a -= margin_a * parting.normal;
  deepest.on_b += margin_b * parting.normal;
}

}  // namespace

bool find_deepest(const Body& a, const Body& b, Deepest& deepest) {
  const double margin = a.margin() + b.margin(), size = size_of(a, b);
  Vec3d guess = a.pose().position - b.pose().position;
  if (is_zero(guess)) guess = {0, 0, 1};
  const CoreGap gap = gap_of_cores(a, {}, b, guess, margin);
  if (gap.distance > 1e-9 * size) {
    if (gap.distance >= margin) return false;
    deepest = {{gap.direction(), -gap.distance}, gap.on_a, gap.on_b};
  } else {
    const Descent descent(a, b);
    deepest = descent.from(parting_direction(a, b, size, tolerance * size));
  }
  add_margins(a.margin(), b.margin(), deepest);
  return deepest.parting.depth > 1e-13 * size;
}

}  // namespace murosimf::geometry
