// Any two convex shapes: the least shift by support functions, then the sides that face each other along it.
#include "murosimf/geometry/build_manifold.h"
#include "murosimf/geometry/facing.h"
#include "murosimf/geometry/pair_tests.h"
#include "murosimf/geometry/penetration.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

/// A face of either that lies about flat against the other's side.
bool meet_at_face(Side& side_a, Side& side_b, const Vec3d& n, Manifold& found) {
  const bool flat_a = side_a.count > 2 && -dot(side_a.normal, n) > flat;
  const bool flat_b = side_b.count > 2 && dot(side_b.normal, n) > flat;
  if (!flat_a && !flat_b) return false;
  const Side& reference = flat_a ? side_a : side_b;
  Side& incident = flat_a ? side_b : side_a;
  const Vec3d out = flat_a ? -n : n;
  clip_by_sides(incident, reference, out);
  add_points_below(incident, reference, out, found);
  return found.count > 0;
}

/// Where the polygon in a rim is not deep enough, or a smooth body has a deeper place than its face: the exact point.
void put_exact_point(const Deepest& deepest, double size, Manifold& found) {
  MUROSIMF_ASSERT(found.count > 0);
  int best = 0;
  for (int i = 1; i < found.count; ++i) {
    if (found.points[i].depth > found.points[best].depth) best = i;
  }
  const double missing = deepest.penetration.depth - found.points[best].depth;
  if (missing > 1e-3 * deepest.penetration.depth + 1e-5 * size) {
    found.points[best].point = 0.5 * (deepest.on_a + deepest.on_b);
    found.points[best].depth = deepest.penetration.depth;
  }
}

}  // namespace

bool collide_general(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b, Manifold& found) {
  Deepest deepest;
  if (!find_deepest(Body(a, at_a), Body(b, at_b), deepest)) return false;
  const Penetration& penetration = deepest.penetration;
  const Vec3d& n = penetration.normal;
  begin(penetration, found);
  Side side_a, side_b;
  find_facing(a, at_a, -n, side_a);
  find_facing(b, at_b, n, side_b);
  std::uint32_t name_a = 0, name_b = 0;
  const Segment line_a = line_facing(a, side_a, -n, name_a), line_b = line_facing(b, side_b, n, name_b);
  if (meet_at_face(side_a, side_b, n, found) ||
      add_side_by_side(penetration, line_a, 0, line_b, 0, joined(name_a, name_b), found)) {
    put_exact_point(deepest, std::min(bounding_radius(a), bounding_radius(b)), found);
    finish(penetration, found);
  } else {
    only_point(penetration, 0.5 * (deepest.on_a + deepest.on_b), joined(name_a, name_b), found);
  }
  return true;
}

}  // namespace murosimf::geometry
