#include "murosimf/geometry/penetration.h"

#include <algorithm>

#include "murosimf/geometry/epa.h"
#include "murosimf/geometry/gjk.h"

namespace murosimf::geometry {
namespace {

constexpr double touching = 1e-9;  // in sizes: a gap of cores that is too small to have a direction
constexpr double nothing = 1e-13;  // in sizes: an overlap that is rounding

void add_margins(double margin_a, double margin_b, Deepest& deepest) {
  Penetration& penetration = deepest.penetration;
  penetration.depth += margin_a + margin_b;
  deepest.on_a -= margin_a * penetration.normal;
  deepest.on_b += margin_b * penetration.normal;
}

}  // namespace

bool find_deepest(const Body& a, const Body& b, Deepest& deepest) {
  const double margin = a.margin() + b.margin();
  const double size = std::min(bounding_radius(a.shape()), bounding_radius(b.shape()));
  Vec3d guess = a.pose().position - b.pose().position;
  if (is_zero(guess)) guess = {0, 0, 1};
  const CoreGap gap = gap_of_cores(a, {}, b, guess, margin);
  if (gap.distance > touching * size) {
    if (gap.distance >= margin) return false;
    deepest = {{gap.direction(), -gap.distance}, gap.on_a, gap.on_b};
  } else {
    deepest = deepest_of_cores(a, b, size);
  }
  add_margins(a.margin(), b.margin(), deepest);
  return deepest.penetration.depth > nothing * size;
}

}  // namespace murosimf::geometry
