#include "murosimf/render/opengl/shaders.h"

namespace murosimf::render {

const std::string_view light_source = R"(
uniform mat4 clip;          // optical frame to clip coordinates
uniform vec3 up;            // of the world
uniform vec3 toward;        // the lamp
uniform vec3 lamp, sky, earth;

vec3 shown(vec3 base, vec3 n, float lit) {
  vec3 light = mix(earth, sky, 0.5 + 0.5 * dot(n, up)) + lamp * (max(0.0, dot(n, toward)) * lit);
  return sqrt(clamp(base * light, 0.0, 1.0));
}
)";

const std::string_view shadow_source = R"(
uniform sampler2DShadow shadow_map;
uniform mat4 to_lamp;      // optical frame to the picture that the lamp sees
uniform float shadow_gap;  // [m] by which a place is moved off its surface before it asks for its shadow

float lit_at(vec3 p, vec3 n) { return texture(shadow_map, (to_lamp * vec4(p + shadow_gap * n, 1.0)).xyz); }
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
out vec3 seen;
out vec3 n;
flat out vec3 base;
flat out float alpha;
flat out uint what;

void main() {
  vec4 p = vec4(place, 1.0);
  seen = vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
  vec3 m = normal * normal_scale;
  n = vec3(dot(row_x.xyz, m), dot(row_y.xyz, m), dot(row_z.xyz, m));
  base = color.rgb * color.rgb;
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
layout(location = 0) out vec4 color;
layout(location = 1) out float depth;
layout(location = 2) out uint label;

void main() {
  vec3 unit = normalize(n);
  color = vec4(shown(base, unit, lit_at(seen, unit)), alpha);
  depth = seen.z;
  label = what;
}
)";

const std::string_view shade_fragment = R"(
void main() {}
)";

const std::string_view ground_vertex = R"(
layout(location = 0) in vec3 place;  // optical frame
out vec3 seen;

void main() {
  seen = place;
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

}  // namespace murosimf::render
