#include "murosimf/render/opengl/shaders.h"

namespace murosimf::render {

const std::string_view light_source = R"(
uniform mat4 clip;            // optical frame to clip coordinates
uniform vec3 up;              // of the world
uniform vec3 toward[3];       // the lamps; the first one casts shadows
uniform vec3 lamp[3];
uniform vec3 sky, earth;
uniform float gloss;
uniform float eye_height;     // [m] above the ground
uniform float eye_behind;     // [m] by which the eye lies behind the origin: far, by parallel rays
uniform float grounded;       // [1] how much the ground darkens what is close to it
uniform vec3 pool_center;     // [m]
uniform float pool_size;      // [1/m^2]

vec3 light_of(vec3 srgb) { return srgb * (srgb * (srgb * (0.50308 - 0.10041 * srgb) + 0.56448) + 0.03285); }

vec3 srgb_of(vec3 light) {
  vec3 c = clamp(light, 0.0, 1.0);
  return mix(1.055 * pow(max(c, vec3(1e-5)), vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThan(c, vec3(0.0031308)));
}

// The mirror of a lamp; `to_eye` and n have unit length.
float mirrored(vec3 n, vec3 to_eye, vec3 way) {
  float x = max(0.0, dot(n, normalize(to_eye + way)));
  x *= x;
  x *= x;
  x *= x;
  x *= x;
  return x * x;
}

vec3 shown(vec3 base, vec3 p, vec3 n, float lit) {
  vec3 light = mix(earth, sky, 0.5 + 0.5 * dot(n, up));
  float height = eye_height + dot(up, p);
  light *= 1.0 - grounded * clamp(1.0 - 6.0 * height, 0.0, 1.0);
  light += lamp[0] * (max(0.0, dot(n, toward[0])) * lit);
  light += lamp[1] * max(0.0, dot(n, toward[1])) + lamp[2] * max(0.0, dot(n, toward[2]));
  vec3 sum = base * light;
  vec3 to_eye = -normalize(p + vec3(0.0, 0.0, eye_behind));
  sum += gloss * (lamp[0] * (lit * mirrored(n, to_eye, toward[0])) + lamp[1] * mirrored(n, to_eye, toward[1]));
  vec3 off = p - pool_center;
  float pool_light = 1.0 / (1.0 + dot(off, off) * pool_size);
  return srgb_of(sum * (pool_light * pool_light));
}
)";

const std::string_view shadow_source = R"(
uniform sampler2DShadow shadow_map;
uniform mat4 to_lamp;      // optical frame to the picture that the lamp sees
uniform float shadow_gap;  // [m] by which a place is moved off its surface before it asks for its shadow

float lit_at(vec3 p, vec3 n) { return texture(shadow_map, (to_lamp * vec4(p + shadow_gap * n, 1.0)).xyz); }
)";

const std::string_view soft_shadow_source = R"(
uniform sampler2DShadow shadow_map;
uniform mat4 to_lamp;
uniform float shadow_gap;
uniform float softness;    // [1] of the picture that the lamp sees: half of a shadow's edge

float lit_at(vec3 p, vec3 n) {
  vec3 at = (to_lamp * vec4(p + shadow_gap * n, 1.0)).xyz;
  float sum = texture(shadow_map, at);
  sum += texture(shadow_map, at + softness * vec3(0.9, 0.4, 0.0)) + texture(shadow_map, at + softness * vec3(-0.9, -0.4, 0.0));
  sum += texture(shadow_map, at + softness * vec3(-0.4, 0.9, 0.0)) + texture(shadow_map, at + softness * vec3(0.4, -0.9, 0.0));
  sum += texture(shadow_map, at + softness * vec3(0.5, -0.2, 0.0)) + texture(shadow_map, at + softness * vec3(-0.5, 0.2, 0.0));
  sum += texture(shadow_map, at + softness * vec3(0.2, 0.5, 0.0)) + texture(shadow_map, at + softness * vec3(-0.2, -0.5, 0.0));
  return sum / 9.0;
}
)";

const std::string_view no_shadow_source = R"(
float lit_at(vec3 p, vec3 n) { return 1.0; }
)";

const std::string_view solid_vertex = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row_x;    // of the instance: solid to optical frame
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
layout(location = 5) in vec3 normal_scale;
layout(location = 6) in vec4 color;
layout(location = 7) in uint label;
#ifdef PICTURED
layout(location = 8) in vec2 in_picture;
out vec2 at;
#endif
out vec3 seen;
out vec3 n;
out vec3 own;  // of the solid
flat out vec3 base;
flat out float alpha;
flat out uint what;

void main() {
  vec4 p = vec4(place, 1.0);
  seen = vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
  vec3 m = normal * normal_scale;
  n = vec3(dot(row_x.xyz, m), dot(row_y.xyz, m), dot(row_z.xyz, m));
  own = place;
#ifdef PICTURED
  at = in_picture;
#endif
  base = light_of(color.rgb);
  alpha = color.a;
  what = label;
  gl_Position = clip * vec4(seen, 1.0);
}
)";

const std::string_view solid_fragment = R"(
in vec3 seen;
in vec3 n;
flat in vec3 base;
flat in float alpha;
flat in uint what;
#ifdef PICTURED
in vec2 at;
uniform sampler2D picture;
#endif
layout(location = 0) out vec4 color;
layout(location = 1) out float depth;
layout(location = 2) out uint label;

void main() {
  vec3 unit = normalize(n), own_light = base;
#ifdef PICTURED
  own_light *= texture(picture, at).rgb;
#endif
  color = vec4(shown(own_light, seen, unit, lit_at(seen, unit)), alpha);
  depth = seen.z;
  label = what;
}
)";

const std::string_view with_picture = "#define PICTURED\n";

const std::string_view ball_fragment = R"(
in vec3 seen;
in vec3 n;
in vec3 own;
flat in vec3 base;
flat in float alpha;
flat in uint what;
layout(location = 0) out vec4 color;
layout(location = 1) out float depth;
layout(location = 2) out uint label;

void main() {
  vec3 unit = normalize(n);
  color = vec4(shown(ball_look(base, own), seen, unit, lit_at(seen, unit)), alpha);
  depth = seen.z;
  label = what;
}
)";

const std::string_view shade_fragment = R"(
void main() {}
)";

const std::string_view ground_vertex = R"(
layout(location = 0) in vec3 place;  // optical frame
layout(location = 1) in vec2 where;  // on the ground
out vec3 seen;
out vec2 at;

void main() {
  seen = place;
  at = where;
  gl_Position = clip * vec4(seen, 1.0);
}
)";

const std::string_view ground_fragment = R"(
in vec3 seen;
uniform vec3 in_light, in_shade;  // as they are shown
uniform uint what;
layout(location = 0) out vec4 color;
layout(location = 1) out float depth;
layout(location = 2) out uint label;

void main() {
  color = vec4(mix(in_shade, in_light, lit_at(seen, vec3(0.0))), 1.0);
  depth = seen.z;
  label = what;
}
)";

const std::string_view lawn_fragment = R"(
in vec3 seen;
in vec2 at;
uniform vec3 in_light, in_shade;  // as they are shown
uniform uint what;
layout(location = 0) out vec4 color;
layout(location = 1) out float depth;
layout(location = 2) out uint label;

void main() {
  float tone = lawn_tone(at, fwidth(at)) * pool_tone(at);
  color = vec4(mix(in_shade, in_light, lit_at(seen, vec3(0.0))) * tone, 1.0);
  depth = seen.z;
  label = what;
}
)";

const std::string_view floor_fragment = R"(
in vec3 seen;
in vec2 at;
uniform vec3 in_light, in_shade;  // as they are shown
uniform uint what;
layout(location = 0) out vec4 color;
layout(location = 1) out float depth;
layout(location = 2) out uint label;

void main() {
  vec3 base = mix(in_shade, in_light, lit_at(seen, vec3(0.0))) * pool_tone(at);
  color = vec4(floor_look(base, at, fwidth(at), length(seen)), 1.0);
  depth = seen.z;
  label = what;
}
)";

const std::string_view stroke_vertex = R"(
layout(location = 0) in vec4 ends;    // [m] on the ground: from x, y to x, y
layout(location = 1) in vec4 size;    // [m] half width, how far it goes beyond its ends; 1: an end is a soft joint
layout(location = 2) in vec3 corner;  // -1 or 1: side; 0 or 1: end; 1: the other end is a soft joint, too
uniform mat4 to_optical;              // of the world
uniform float pixel;                  // [1] tangent that a pixel takes; [m] by parallel rays
uniform vec4 eye;                     // [m] of the world, 1; by parallel rays: the direction to it, 0
out vec3 seen;
out vec2 local;                       // [m] along, across
flat out vec4 extent;                 // [m] half width, first and last of along; 0
flat out vec2 soft;
out vec2 at_ground;

void main() {
  vec2 along = ends.zw - ends.xy;
  float size_along = length(along);
  vec2 dir = along / size_along;
  vec2 across = vec2(-dir.y, dir.x);
  vec2 at = corner.y > 0.5 ? ends.zw : ends.xy;
  // half of a pixel's footprint on the ground, seen from far: z pixel to the side, z^2 pixel / height away from the eye
  // (z = 1 by parallel rays: the height is the sine of their elevation)
  vec2 away = eye.w * at - eye.xy;
  float height = eye.z;
  float z = max(0.1, length(vec3(away, height)));
  away /= max(length(away), 0.001);
  vec2 reach = 0.75 * pixel * z * vec2(1.0, z / height);
  vec2 side = vec2(-away.y, away.x);
  vec2 room = min(vec2(1.0), vec2(abs(dot(along, side)) / size_along, abs(dot(across, side))) * reach.x +
                             vec2(abs(dot(along, away)) / size_along, abs(dot(across, away))) * reach.y);
  float beyond = (corner.y > 0.5 ? size.z : size.y) + room.x;
  float forward = corner.y > 0.5 ? 1.0 : -1.0;
  local = vec2(corner.y * size_along + forward * beyond, corner.x * (size.x + room.y));
  extent = vec4(size.x, -size.y, size_along + size.z, 0.0);
  soft = vec2(size.w, corner.z);
  vec2 p = ends.xy + local.x * dir + local.y * across;
  at_ground = p;
  seen = (to_optical * vec4(p, 0.0, 1.0)).xyz;
  gl_Position = clip * vec4(seen, 1.0);
}
)";

const std::string_view stroke_fragment = R"(
in vec3 seen;
in vec2 local;
flat in vec4 extent;
flat in vec2 soft;
uniform vec3 in_light, in_shade;
uniform uint what;
uniform float least;  // cover below which nothing is drawn
layout(location = 0) out vec4 color;
layout(location = 2) out uint label;

float share(float x, float low, float high, float footprint) {
  return clamp((min(x + 0.5 * footprint, high) - max(x - 0.5 * footprint, low)) / footprint, 0.0, 1.0);
}

void main() {
  float a = length(vec2(dFdx(local.x), dFdy(local.x))) + 1e-9;
  float b = length(vec2(dFdx(local.y), dFdy(local.y))) + 1e-9;
  float low = extent.y - 0.5 * a * soft.x, high = extent.z + 0.5 * a * soft.y;
  float cover = share(local.x, low, high, a) * share(local.y, -extent.x, extent.x, b);
  if (cover <= least) discard;
  color = vec4(mix(in_shade, in_light, lit_at(seen, vec3(0.0))), cover);
  label = what;
}
)";

const std::string_view painted_fragment = R"(
in vec3 seen;
in vec2 local;
in vec2 at_ground;
flat in vec4 extent;
flat in vec2 soft;
uniform vec3 in_light, in_shade;
layout(location = 0) out vec4 color;

void main() {
  float a = length(vec2(dFdx(local.x), dFdy(local.x))) + 1e-9;
  float b = length(vec2(dFdx(local.y), dFdy(local.y))) + 1e-9;
  float low = extent.y - 0.5 * a * soft.x, high = extent.z + 0.5 * a * soft.y;
  float ragged = 0.008 * max(0.0, pile_at(vec2(0.11 * local.x, 3.0 * extent.x * sign(local.y))));
  float cover = share_between(local.x, low, high, a) * share_between(local.y, ragged - extent.x, extent.x - ragged, b);
  if (cover <= 0.0) discard;
  color = vec4(mix(in_shade, in_light, lit_at(seen, vec3(0.0))) * pool_tone(at_ground), worn(cover, at_ground));
}
)";

const std::string_view contact_vertex = R"(
layout(location = 0) in vec3 place;  // optical frame
layout(location = 1) in vec2 where;  // [m] from the middle of what is above the ground, in its axes
layout(location = 2) in vec4 size;   // [m] half of its sides, and how far its shadow reaches; [1] how dark it is
out vec2 at;
flat out vec4 extent;

void main() {
  at = where;
  extent = size;
  gl_Position = clip * vec4(place, 1.0);
}
)";

const std::string_view contact_fragment = R"(
in vec2 at;
flat in vec4 extent;
layout(location = 0) out vec4 color;

void main() {
  float x = clamp(1.0 - length(max(abs(at) - extent.xy, 0.0)) / extent.z, 0.0, 1.0);
  color = vec4(0.0, 0.0, 0.0, extent.w * x * x);
}
)";

const std::string_view surface_vertex = R"(
layout(location = 0) in vec3 place;  // world
layout(location = 1) in vec2 where;
uniform mat4 to_optical;
out vec2 at;

void main() {
  at = where;
  gl_Position = clip * (to_optical * vec4(place, 1.0));
}
)";

const std::string_view wall_fragment = R"(
in vec2 at;
layout(location = 0) out vec4 color;
void main() { color = vec4(wall_look(at, fwidth(at)), 1.0); }
)";

const std::string_view ceiling_fragment = R"(
in vec2 at;
layout(location = 0) out vec4 color;
void main() { color = vec4(ceiling_look(at, fwidth(at)), 1.0); }
)";

const std::string_view net_fragment = R"(
in vec2 at;
uniform vec3 in_light;
layout(location = 0) out vec4 color;
void main() { color = vec4(in_light, 0.85 * net_cover(at)); }
)";

const std::string_view sky_vertex = R"(
layout(location = 0) in vec2 place;  // clip coordinates
uniform vec4 window;                 // tangents: middle of the picture, half of its sides
uniform mat3 to_world;
out vec3 way;

void main() {
  way = to_world * vec3(window.xy + window.zw * place, 1.0);
  gl_Position = vec4(place, 1.0, 1.0);
}
)";

const std::string_view sky_fragment = R"(
in vec3 way;
layout(location = 0) out vec4 color;
void main() { color = vec4(sky_look(way), 1.0); }
)";

}  // namespace murosimf::render
