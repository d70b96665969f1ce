/// patterns.h - the patterns of look_patterns.h in lanes: the same formulas under the same names, each filtered over the footprint of a pixel.
#pragma once

#include "murosimf/render/software/look_values.h"

namespace murosimf::render::software {

struct Floats2 {
  Floats x, y;
};

/// What a pixel covers of a number: the sum of its changes to the right and downwards (fwidth of GLSL). Divisions take longest, so its
/// inverse comes along.
struct Footprint {
  explicit Footprint(const Floats& covered) : size(covered), per_size(1 / covered) {}
  Footprint(const Floats& covered, const Floats& inverse) : size(covered), per_size(inverse) {}
  [[nodiscard]] Footprint scaled(float by) const { return {size * by, per_size * (1 / by)}; }
  [[nodiscard]] friend Footprint larger(const Footprint& a, const Footprint& b) {
    return {greatest(a.size, b.size), least(a.per_size, b.per_size)};
  }
  Floats size, per_size;
};
struct Footprints {
  Footprint x, y;
};

[[nodiscard]] inline Floats share_between(const Floats& x, const Floats& low, const Floats& high, const Footprint& f) {
  return limited((least(x + 0.5F * f.size, high) - greatest(x - 0.5F * f.size, low)) * f.per_size, 0, 1);
}
[[nodiscard]] inline Floats share_between(const Floats& x, float low, float high, const Footprint& f) {
  return share_between(x, all_lanes(low), all_lanes(high), f);
}
[[nodiscard]] inline Floats share_above(const Floats& x, const Floats& low, const Floats& per_f) {
  return limited(0.5F + (x - low) * per_f, 0, 1);
}
[[nodiscard]] inline Floats share_of_bars(const Floats& x, float period, float wide, const Footprint& f) {
  const float per_period = 1 / period;
  const Floats near = (fraction(x * per_period + 0.5F) - 0.5F) * period;
  return mixed(share_between(near, -0.5F * wide, 0.5F * wide, f), all_lanes(wide * per_period),
               limited((2 * per_period) * f.size - 0.5F, 0, 1));
}
[[nodiscard]] inline Floats square_wave(const Floats& t, const Footprint& f) {
  const auto sum = [](const Floats& end) { return 0.5F - magnitude(fraction(end) - 0.5F); };
  return (sum(t + 0.5F * f.size) - sum(t - 0.5F * f.size)) * f.per_size;
}

/// Height of the pile; mean 0.
[[nodiscard]] inline Floats pile_at(const Floats2& at, const Footprint& cells) {
  const Floats a = fraction(floor_of(at.x * 250.0F) * 0.1031F), b = fraction(floor_of(at.y * 180.0F) * 0.1030F);
  const Floats shift = a * (b + 33.33F) + b * (a + 33.33F);
  return (fraction((a + b + 2 * shift) * (a + shift)) - 0.5F) * least(0.6F * cells.per_size, all_lanes(0.4F));
}
/// The footprint in its cells.
[[nodiscard]] inline Footprint pile_cells(const Footprints& f) { return larger(f.x.scaled(250), f.y.scaled(180)); }

[[nodiscard]] inline Floats lawn_tone(const LookValues& look, const Floats2& at, const Footprints& f,
                                      const Floats& pile) {
  const Floats beyond = greatest(magnitude(at.x) - look.lines_reach[0], magnitude(at.y) - look.lines_reach[1]);
  const float per_pair = 1 / (2 * look.stripe[0]);
  const Floats stripes = 1 + 0.55F * pile + look.stripe[1] * square_wave(at.x * per_pair, f.x.scaled(per_pair));
  const Floats border = share_above(beyond, Floats{}, least(f.x.per_size, f.y.per_size));
  if (!any(border > 0)) return stripes;
  return mixed(stripes, 1 + 0.55F * pile, border) * (1 - 0.10F * border);
}

[[nodiscard]] inline Floats pool_tone(const LookValues& look, const Floats2& at) {
  return look.pool > 0 ? 1 / (1 + (at.x * at.x + at.y * at.y) * look.pool) : all_lanes(1.0F);
}

[[nodiscard]] inline Floats3 floor_look(const LookValues& look, const Floats3& base, const Floats2& at,
                                        const Footprints& f, const Floats& pile, const Floats& away_squared) {
  const Floats joints = greatest(share_of_bars(at.x, 1.5F, 0.012F, f.x), share_of_bars(at.y, 1.5F, 0.012F, f.y));
  const Floats tone = 1 - 0.16F * (1 - look.haze) * joints + (0.10F + 0.5F * look.haze) * pile;
  return mixed(base * tone, all_lanes(look.hedge), look.haze * away_squared / (away_squared + 900));
}

[[nodiscard]] inline Floats3 wall_look(const LookValues& look, const Floats2& at, const Footprints& f) {
  Floats3 c = mixed(all_lanes(look.dado), all_lanes(look.wall), share_above(at.y, all_lanes(1.2F), f.y.per_size));
  const Floats sill = share_between(at.y, 1.17F, 1.23F, f.y);
  if (any(sill > 0)) c = mixed(c, (all_lanes(look.wall) + all_lanes(look.pane)) * all_lanes(0.5F), sill);
  Floats tone = 1 - 0.10F * share_of_bars(at.x, 3, 0.03F, f.x);
  tone *= 0.80F + 0.20F * limited(at.y * (1 / look.wall_height), 0, 1);
  tone *= 1 - 0.22F / (1 + 30 * at.y * at.y);
  c = c * tone;
  Floats panes = share_between(at.y, look.wall_height - 1.7F, look.wall_height - 0.5F, f.y);
  if (!any(panes > 0)) return c;
  panes *= share_of_bars(at.x - 1.5F, 3, 2.3F, f.x) * (1 - share_of_bars(at.x - 1.5F, 1.15F, 0.05F, f.x));
  return mixed(c, all_lanes(look.pane), panes);
}

[[nodiscard]] inline Floats3 ceiling_look(const LookValues& look, const Floats2& at, const Footprints& f) {
  const Floats lamps = share_of_bars(at.x - 1.2F, 2.4F, 1.2F, f.x) * share_of_bars(at.y - 1, 2, 0.16F, f.y);
  const Floats beams = share_of_bars(at.x, 2.4F, 0.15F, f.x);
  return mixed(all_lanes(look.ceiling) * (1 - 0.25F * beams), all_lanes(look.tube), lamps);
}

/// The sky in a direction of the world, with what stands at the horizon.
[[nodiscard]] Floats3 sky_look(const LookValues& look, const Floats3& way);

/// The share of a net's threads; derivatives of the place by u and v.
[[nodiscard]] inline Floats net_cover(const Floats2& at, const Floats2& per_u, const Floats2& per_v) {
  constexpr float half_root = 0.7071F;
  const auto bars = [&](const Floats& x, const Floats& xu, const Floats& xv) {
    const Floats f = half_root * greatest(magnitude(xu) + magnitude(xv), all_lanes(1e-5F));
    return share_of_bars(half_root * x, 0.06F, 0.004F, Footprint(f));
  };
  const Floats one = bars(at.x + at.y, per_u.x + per_u.y, per_v.x + per_v.y);
  const Floats other = bars(at.x - at.y, per_u.x - per_u.y, per_v.x - per_v.y);
  return one + other - one * other;
}

[[nodiscard]] inline Floats worn(const Floats& cover, const Floats& pile) {
  return cover * (1 - limited(0.06F - 0.45F * pile, 0, 0.25F));
}

struct BallPanels {
  Floats pentagon;  ///< 1 in the twelve pentagons
  Floats seam;      ///< 1 in seams
};
/// The panels of a ball in the direction p from its middle; in those of the pixels to the right and below.
[[nodiscard]] BallPanels ball_panels(const Floats3& p, const Floats3& right, const Floats3& below);

}  // namespace murosimf::render::software
