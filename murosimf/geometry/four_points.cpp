#include "murosimf/geometry/four_points.h"

#include "murosimf/geometry/spread.h"
#include "murosimf/math/assert.h"

namespace murosimf::geometry {
namespace {

/// The point of the largest measure(point), if that is positive; of about equal ones, the first. Else -1.
template <class Measure>
int farthest(const Manifold& manifold, const Measure& measure) {
  int best = -1;
  double most = 0;
  for (int i = 0; i < manifold.count; ++i) {
    const double far = measure(manifold.points[i].point);
    if (far > detail::clearly_farther * most) {
      most = far;
      best = i;
    }
  }
  return best;
}

double square(double x) { return x * x; }

int deepest_of(const Manifold& manifold, const Chosen& among) {
  int best = among.index[0];
  MUROSIMF_ASSERT(among.count > 0);
  for (int k = 1; k < among.count; ++k) {
    if (manifold.points[among.index[k]].depth > manifold.points[best].depth) best = among.index[k];
  }
  return best;
}

void take_deepest(const Manifold& manifold, const Chosen& all, double width, Chosen& chosen) {
  const int deepest = deepest_of(manifold, all);
  const ManifoldPoint& wanted = manifold.points[deepest];
  const double missing = wanted.depth - manifold.points[deepest_of(manifold, chosen)].depth;
  if (!(missing > std::min(detail::clearly_deeper * wanted.depth, detail::clearly_leaning * width))) return;
  int nearest = 0;
  MUROSIMF_ASSERT(chosen.count > 0);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < chosen.count; ++k) {
    const Vec3d way = manifold.points[chosen.index[k]].point - wanted.point;
    if (dot(way, way) < least) {
      least = dot(way, way);
      nearest = k;
    }
  }
  chosen.index[nearest] = deepest;
}

}  // namespace

void keep_four(Manifold& manifold) noexcept {
  if (manifold.count <= 4) return;
  Chosen all, chosen;
  for (; all.count < manifold.count; ++all.count) all.index[all.count] = all.count;
  const auto choose = [&](int i) {
    if (i >= 0) chosen.index[chosen.count++] = i;
    MUROSIMF_ASSERT(i < manifold.count && chosen.count <= 4);
  };
  const Vec3d first = manifold.points[0].point;
  choose(0);
  choose(farthest(manifold, [&](const Vec3d& p) { return square(norm(p - first)); }));
  if (chosen.count < 2) return void(manifold.count = 1);  // all in one place
  const Vec3d along = manifold.points[chosen.index[1]].point - first;
  const Vec3d aside = cross(manifold.normal, along);
  choose(farthest(manifold, [&](const Vec3d& p) { return square(std::max(0.0, dot(aside, p - first))); }));
  choose(farthest(manifold, [&](const Vec3d& p) { return square(std::max(0.0, -dot(aside, p - first))); }));
  take_deepest(manifold, all, norm(along), chosen);
  insertion_sort(chosen.index.begin(), chosen.index.begin() + chosen.count);
  for (int k = 0; k < chosen.count; ++k) manifold.points[k] = manifold.points[chosen.index[k]];
  manifold.count = chosen.count;
  MUROSIMF_ASSERT(manifold.count > 0 && manifold.count <= 4);
}

}  // namespace murosimf::geometry
