#include "murosimf/render/look_patterns.h"

namespace murosimf::render {

const std::string_view look_patterns = R"(
uniform vec2 lines_reach;     // [m] to both sides; beyond them the field is darker
uniform vec2 stripe;          // [m] width of mown stripes, [1] contrast
uniform float pool;           // [1/m^2]
uniform float haze;           // [1] 1: what is far has the color of the hedge
uniform vec3 wall, dado, ceiling, pane, tube;
uniform float wall_height;    // [m]
uniform vec3 zenith, horizon, hedge, sun, sun_toward;

// The share of a footprint of f about x that lies between low and high.
float share_between(float x, float low, float high, float f) {
  return clamp((min(x + 0.5 * f, high) - max(x - 0.5 * f, low)) / f, 0.0, 1.0);
}
float share_above(float x, float low, float f) { return clamp(0.5 + (x - low) / f, 0.0, 1.0); }
// The share under bars of `wide` about all multiples of `period`.
float share_of_bars(float x, float period, float wide, float f) {
  float near = (fract(x / period + 0.5) - 0.5) * period;
  return mix(share_between(near, -0.5 * wide, 0.5 * wide, f), wide / period, clamp(2.0 * f / period - 0.5, 0.0, 1.0));
}
// The mean of a wave that is 1 and -1 by turns.
float square_wave(float t, float f) {
  vec2 ends = vec2(t + 0.5 * f, t - 0.5 * f);
  vec2 sums = 0.5 - abs(fract(ends) - 0.5);
  return (sums.x - sums.y) / f;
}

float pile_at(vec2 at);  // height of the pile, mean 0, deviation 0.1

// What the color of the field is multiplied with at a place of the world.
float lawn_tone(vec2 at, vec2 f) {
  vec2 beyond = abs(at) - lines_reach;
  float border = share_above(max(beyond.x, beyond.y), 0.0, max(f.x, f.y));
  float stripes = square_wave(at.x / (2.0 * stripe.x), f.x / (2.0 * stripe.x));
  return (1.0 + stripe.y * stripes * (1.0 - border) + 0.55 * pile_at(at)) * (1.0 - 0.10 * border);
}

// The same for the light of a pool around the middle.
float pool_tone(vec2 at) { return 1.0 / (1.0 + dot(at, at) * pool); }

// Floor around the field, `away` [m] from the eye: large tiles in a hall, earth outdoors.
vec3 floor_look(vec3 base, vec2 at, vec2 f, float away) {
  float joints = max(share_of_bars(at.x, 1.5, 0.012, f.x), share_of_bars(at.y, 1.5, 0.012, f.y));
  float tone = 1.0 - 0.16 * joints * (1.0 - haze) + (0.10 + 0.5 * haze) * pile_at(at);
  float far = away * away;
  return mix(base * tone, hedge, haze * far / (far + 900.0));
}

// A wall; at: along, above the floor.
vec3 wall_look(vec2 at, vec2 f) {
  vec3 c = mix(dado, wall, share_above(at.y, 1.2, f.y));
  c = mix(c, 0.5 * (wall + pane), share_between(at.y, 1.17, 1.23, f.y));
  float panes = share_of_bars(at.x - 1.5, 3.0, 2.3, f.x) * share_between(at.y, wall_height - 1.7, wall_height - 0.5, f.y);
  panes *= 1.0 - share_of_bars(at.x - 1.5, 1.15, 0.05, f.x);
  c *= 1.0 - 0.10 * share_of_bars(at.x, 3.0, 0.03, f.x);
  c *= 0.80 + 0.20 * clamp(at.y / wall_height, 0.0, 1.0);
  c *= 1.0 - 0.22 / (1.0 + 30.0 * at.y * at.y);
  return mix(c, pane, panes);
}

// The ceiling with its lamps; at: x and y.
vec3 ceiling_look(vec2 at, vec2 f) {
  float lamps = share_of_bars(at.x - 1.2, 2.4, 1.2, f.x) * share_of_bars(at.y - 1.0, 2.0, 0.16, f.y);
  float beams = share_of_bars(at.x, 2.4, 0.15, f.x);
  return mix(ceiling * (1.0 - 0.25 * beams), tube, lamps);
}

// The sky in a direction of the world, with what stands at the horizon.
vec3 sky_look(vec3 way) {
  vec3 d = way * inversesqrt(dot(way, way));
  float up = clamp(d.z, 0.0, 1.0);
  vec3 c = mix(horizon, zenith, sqrt(up) * (1.6 - 0.6 * up) * 0.95);
  float glow = max(0.0, dot(d, sun_toward));
  float near = glow * glow;
  near *= near;
  c = mix(c, sun, 0.35 * near * near * near * near);
  c = mix(c, sun, share_above(glow, 0.9993, 0.0004));
  float trees = 0.050 + 0.009 * sin(9.0 * d.x + 3.0 * d.y) + 0.006 * sin(23.0 * d.y - 11.0 * d.x) +
                0.004 * sin(61.0 * d.x + 47.0 * d.y) + 0.003 * sin(149.0 * d.x - 113.0 * d.y);
  return mix(hedge, c, share_above(d.z, trees, 0.004));
}

// The share of a net's threads; at: along both of its sides.
float net_cover(vec2 at) {
  vec2 turned = 0.7071 * vec2(at.x + at.y, at.x - at.y);
  vec2 f = max(fwidth(turned), vec2(1e-5));
  float one = share_of_bars(turned.x, 0.06, 0.004, f.x), other = share_of_bars(turned.y, 0.06, 0.004, f.y);
  return one + other - one * other;
}

// Painted fibers stand apart: what is left of paint where it covers `cover`.
float worn(float cover, vec2 at) { return cover * (1.0 - clamp(0.06 - 0.45 * pile_at(at), 0.0, 0.25)); }

// 32 panels of a ball in the direction p from its middle: x is 1 in the twelve pentagons, y is 1 in seams. A truncated icosahedron has
// its faces at the corners of an icosahedron and of a dodecahedron, at distances of 2.3274 and 2.2673 of its edge.
vec2 ball_panels(vec3 p) {
  vec3 a = abs(normalize(p));
  vec3 five = vec3(dot(a, vec3(0.0, 0.52573, 0.85065)), dot(a, vec3(0.85065, 0.0, 0.52573)), dot(a, vec3(0.52573, 0.85065, 0.0)));
  vec4 six = vec4(dot(a, vec3(0.57735)), dot(a, vec3(0.0, 0.93417, 0.35682)), dot(a, vec3(0.35682, 0.0, 0.93417)),
                  dot(a, vec3(0.93417, 0.35682, 0.0)));
  vec3 across = vec3(dot(a, vec3(0.0, 0.93417, -0.35682)), dot(a, vec3(-0.35682, 0.0, 0.93417)), dot(a, vec3(0.93417, -0.35682, 0.0)));
  five /= 2.3274;
  six /= 2.2673;
  across /= 2.2673;
  float pentagon = max(five.x, max(five.y, five.z));
  vec2 low = min(six.xz, six.yw), high = max(six.xz, six.yw);
  float first = max(high.x, high.y);
  float second = max(max(min(high.x, high.y), max(low.x, low.y)), max(across.x, max(across.y, across.z)));
  float f = max(fwidth(pentagon - first), 1e-5), g = max(fwidth(first - second), 1e-5);
  float inside = share_above(pentagon, first, f);
  float seam = max(share_between(pentagon - first, -0.004, 0.004, f), (1.0 - inside) * share_between(first - second, -1.0, 0.006, g));
  return vec2(inside, seam);
}

// A ball of the color `base` (linear): white ones have black pentagons, others darker ones.
vec3 ball_look(vec3 base, vec3 p) {
  vec2 panel = ball_panels(p);
  float most = max(base.r, max(base.g, base.b)), least = min(base.r, min(base.g, base.b));
  float dark = mix(0.03, 0.45, clamp(2.0 * (most - least) / max(most, 0.01), 0.0, 1.0));
  return base * mix(1.0, dark, panel.x) * (1.0 - 0.45 * panel.y);
}
)";

const std::string_view fine_pile = R"(
uniform sampler2D pile;    // mean 0.5
uniform float pile_scale;  // [1/m]
float pile_at(vec2 at) { return texture(pile, at * pile_scale).r - 0.5; }
)";

const std::string_view quick_pile = R"(
float pile_at(vec2 at) {
  vec2 cell = at * vec2(250.0, 180.0);
  float f = max(fwidth(cell.x), fwidth(cell.y));
  vec2 mixed = fract(floor(cell) * vec2(0.1031, 0.1030));
  mixed += dot(mixed, mixed.yx + 33.33);
  return (fract((mixed.x + mixed.y) * mixed.x) - 0.5) * clamp(0.6 / f, 0.0, 0.4);
}
)";

}  // namespace murosimf::render
