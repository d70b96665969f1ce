#include "murosimf/geometry/build_manifold.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::geometry {

void begin(const Penetration& penetration, Manifold& found) {
  found.normal = penetration.normal;
  found.count = 0;
}

void only_point(const Penetration& penetration, const Vec3d& middle, std::uint32_t name, Manifold& found) {
  found.normal = penetration.normal;
  MUROSIMF_ASSERT(!found.points.empty());
  found.count = 1;
  found.points[0] = {middle, penetration.depth, name};
}

bool add_side_by_side(const Penetration& penetration, const Segment& a, double radius_a, const Segment& b,
                      double radius_b, std::uint32_t name, Manifold& found) {
  const double aa = dot(a.half, a.half), bb = dot(b.half, b.half);
  const Vec3d across = cross(a.half, b.half);
  if (!(aa > 0 && bb > 0) || dot(across, across) > side_by_side * side_by_side * aa * bb) return false;
  const double lean = dot(a.half, penetration.normal);
  if (lean * lean > 0.01 * aa) return false;
  // B's ends on A's line, in halves of A
  const double middle = dot(b.middle - a.middle, a.half) / aa, reach = std::abs(dot(b.half, a.half)) / aa;
  const double low = std::max(-1.0, middle - reach), high = std::min(1.0, middle + reach);
  if (!((high - low) * std::sqrt(aa) > 1e-3 * std::sqrt(std::min(aa, bb)))) return false;
  const int before = found.count;
  const Vec3d& n = penetration.normal;
  const double most_aside = 4 * side_by_side * side_by_side * std::min(aa, bb);
  for (const double s : {low, high}) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(found.count) < found.points.size());
    const Vec3d on_a = a.at(s);
    const Vec3d on_b = b.at(std::clamp(dot(on_a - b.middle, b.half) / bb, -1.0, 1.0));
    const double depth = radius_a + radius_b - dot(on_a - on_b, n);
    const Vec3d aside = tangential(on_a - on_b, n);
    if (!(depth > 0) || dot(aside, aside) > most_aside) continue;
    const Vec3d point = 0.5 * (on_a + on_b + (radius_b - radius_a) * n);
    found.points[found.count++] = {point, depth, joined(name, s == low ? 1 : 2)};
  }
  return found.count > before;
}

void finish(const Penetration& penetration, Manifold& found) {
  MUROSIMF_ASSERT(found.count >= 0 && static_cast<std::size_t>(found.count) <= found.points.size());
  for (int i = 1; i < found.count; ++i) {
    for (int k = 0; k < i; ++k) {
      if (found.points[k].feature == found.points[i].feature) {
        ++found.points[i].feature;
        k = -1;
      }
    }
  }
  const auto end = found.points.begin() + found.count;
  const auto deepest =
      std::max_element(found.points.begin(), end, [](const auto& a, const auto& b) { return a.depth < b.depth; });
  if (deepest != end) deepest->depth = penetration.depth;
}

}  // namespace murosimf::geometry
