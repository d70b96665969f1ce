#include "murosimf/render/software/patterns.h"

namespace murosimf::render::software {
namespace {

/// The sine; |x| < 1000. From the nearest multiple of pi on by its series, to the ninth power: exact to 4e-6.
Floats sine(const Floats& x) {
  const Floats turns = floor_of(x * 0.318309886F + 0.5F);
  const Floats r = (x - turns * 3.140625F) - turns * 9.67653589793e-4F, s = r * r;
  const Floats odd = turns - 2 * floor_of(0.5F * turns);
  const Floats wave = r * (1 + s * (-1.6666667e-1F + s * (8.3333333e-3F + s * (-1.9841270e-4F + s * 2.7557319e-6F))));
  return wave * (1 - 2 * odd);
}

/// How high trees stand in a direction.
Floats trees(const Floats3& d) {
  return 0.050F + 0.009F * sine(9 * d.x + 3 * d.y) + 0.006F * sine(23 * d.y - 11 * d.x) +
         0.004F * sine(61 * d.x + 47 * d.y) + 0.003F * sine(149 * d.x - 113 * d.y);
}

}  // namespace

Floats3 sky_look(const LookValues& look, const Floats3& way) {
  constexpr float per_edge = 1 / 0.0004F, per_treetop = 1 / 0.004F, highest_tree = 0.08F;
  const Floats3 d = way * (1 / root(dot(way, way)));
  const Floats up = limited(d.z, 0, 1);
  Floats3 c = mixed(all_lanes(look.horizon), all_lanes(look.zenith), root(up) * (1.6F - 0.6F * up) * 0.95F);
  const Floats glow = greatest(Floats{}, dot(d, look.sun_toward));
  Floats near = glow;
  for (int i = 0; i < 4; ++i) near *= near;  // the 16th power
  c = mixed(c, all_lanes(look.sun), 0.35F * near);
  c = mixed(c, all_lanes(look.sun), share_above(glow, all_lanes(0.9993F), all_lanes(per_edge)));
  if (!any(d.z < highest_tree)) return c;
  return mixed(all_lanes(look.hedge), c, share_above(d.z, trees(d), all_lanes(per_treetop)));
}

}  // namespace murosimf::render::software
