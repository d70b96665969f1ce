#include "murosimf/render/software/patterns.h"

namespace murosimf::render::software {
namespace {

/// Along the axes of faces, relative to their distance from the middle: the nearest pentagon, the nearest and the second hexagon.
struct Nearest {
  Floats pentagon, first, second;
};

Floats along(const Floats3& p, float x, float y, float z) { return x * p.x + y * p.y + z * p.z; }
Floats most(const Floats& a, const Floats& b, const Floats& c) { return greatest(a, greatest(b, c)); }

Nearest nearest_faces(const Floats3& p) {
  const Floats per_length = 1 / root(dot(p, p));
  const Floats3 a{magnitude(p.x) * per_length, magnitude(p.y) * per_length, magnitude(p.z) * per_length};
  constexpr float long_five = 0.85065F, short_five = 0.52573F, long_six = 0.93417F, short_six = 0.35682F;
  constexpr float five_away = 2.3274F, six_away = 2.2673F;
  const Floats five =
      most(along(a, 0, short_five, long_five), along(a, long_five, 0, short_five), along(a, short_five, long_five, 0));
  const Floats six_x = along(a, 0.57735F, 0.57735F, 0.57735F), six_y = along(a, 0, long_six, short_six);
  const Floats six_z = along(a, short_six, 0, long_six), six_w = along(a, long_six, short_six, 0);
  const Floats across =
      most(along(a, 0, long_six, -short_six), along(a, -short_six, 0, long_six), along(a, long_six, -short_six, 0));
  const Floats low_x = least(six_x, six_y), low_y = least(six_z, six_w);
  const Floats high_x = greatest(six_x, six_y), high_y = greatest(six_z, six_w);
  return {five / five_away, greatest(high_x, high_y) / six_away,
          most(least(high_x, high_y), greatest(low_x, low_y), across) / six_away};
}

}  // namespace

BallPanels ball_panels(const Floats3& p, const Floats3& right, const Floats3& below) {
  const Nearest here = nearest_faces(p), at_right = nearest_faces(right), at_below = nearest_faces(below);
  const auto footprint = [](const Floats& x, const Floats& x_right, const Floats& x_below) {
    return Footprint(greatest(magnitude(x_right - x) + magnitude(x_below - x), all_lanes(1e-5F)));
  };
  const Floats edge = here.pentagon - here.first, between = here.first - here.second;
  const Footprint f = footprint(edge, at_right.pentagon - at_right.first, at_below.pentagon - at_below.first);
  const Footprint g = footprint(between, at_right.first - at_right.second, at_below.first - at_below.second);
  const Floats inside = share_above(here.pentagon, here.first, f.per_size);
  return {inside,
          greatest(share_between(edge, -0.004F, 0.004F, f), (1 - inside) * share_between(between, -1, 0.006F, g))};
}

}  // namespace murosimf::render::software
