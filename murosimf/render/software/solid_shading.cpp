#include "murosimf/render/software/solid_shading.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/render/software/patterns.h"
#include "murosimf/render/software/picture_light.h"

namespace murosimf::render::software {
namespace {

constexpr int srgb_steps = 1 << 13;

using SrgbTable = std::array<float, srgb_steps + 1>;

const SrgbTable srgb_table = [] {
  SrgbTable made{};
  for (int i = 0; i <= srgb_steps; ++i) {
    const double c = static_cast<double>(i) / srgb_steps;
    // IEC 61966-2-1
    made[static_cast<std::size_t>(i)] =
        static_cast<float>(c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
  }
  return made;
}();

/// sRGB [1] of a linear brightness.
Floats srgb_of(const Floats& linear) {
  const Ints index = whole_numbers(limited(linear, 0, 1) * static_cast<float>(srgb_steps) + 0.5F);
  Floats result;
  for (int i = 0; i < pixel_lanes; ++i) result[i] = srgb_table[static_cast<std::size_t>(index[i])];
  return result;
}

Floats3 at(const std::array<Slope, 3>& slopes, const Floats& from_u, float from_v) {
  return {slopes[0].at(from_u, from_v), slopes[1].at(from_u, from_v), slopes[2].at(from_u, from_v)};
}

Floats mirror_power(const Floats& cosine) {
  Floats x = greatest(Floats{}, cosine);
  for (int i = 0; i < 5; ++i) x *= x;  // the 32nd power
  return x;
}

/// What a pixel covers of a place on a surface: its derivatives.
struct Place {
  Floats2 at, per_u, per_v;
  [[nodiscard]] Footprints footprint() const {
    return {Footprint(magnitude(per_u.x) + magnitude(per_v.x)), Footprint(magnitude(per_u.y) + magnitude(per_v.y))};
  }
};
Place place_on(const Surface& surface, const Floats& from_u, float from_v, const Floats& per_z) {
  const Floats z = 1 / per_z;
  Place place;
  place.at = {surface.place[0].at(from_u, from_v) * z, surface.place[1].at(from_u, from_v) * z};
  const auto derivative = [&](const Floats& x, float per_pixel, float per_z_per_pixel) {
    return z * (per_pixel - x * per_z_per_pixel);
  };
  place.per_u = {derivative(place.at.x, surface.place[0].per_u, surface.per_z.per_u),
                 derivative(place.at.y, surface.place[1].per_u, surface.per_z.per_u)};
  place.per_v = {derivative(place.at.x, surface.place[0].per_v, surface.per_z.per_v),
                 derivative(place.at.y, surface.place[1].per_v, surface.per_z.per_v)};
  return place;
}

/// A number that is linear in the picture once it is multiplied with 1 / z, of pixels that show different surfaces.
struct GatheredSlope {
  Floats value{}, per_u{}, per_v{};  // value: at the pixel, times 1 / z
  void set(int lane, const Slope& slope, float from_u, float from_v) {
    value[lane] = slope.at(from_u, from_v);
    per_u[lane] = slope.per_u;
    per_v[lane] = slope.per_v;
  }
};

/// The light of the pictures that some lanes show, by different surfaces: as by place_on() for each of them.
Floats3 light_of_pictures(std::span<const Surface> surfaces, const Ints& numbers, unsigned lanes, int v, int u,
                          const Floats& per_z) {
  PicturePoints points;
  GatheredSlope slope, right, down;
  for (; lanes != 0; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const Surface& surface = surfaces[static_cast<std::size_t>(numbers[i])];
    const float from_u = static_cast<float>(u + i) - surface.anchor.u,
                from_v = static_cast<float>(v) - surface.anchor.v;
    points.pictures[static_cast<std::size_t>(i)] = surface.picture;
    slope.set(i, surface.per_z, from_u, from_v);
    right.set(i, surface.place[0], from_u, from_v);
    down.set(i, surface.place[1], from_u, from_v);
  }
  const Floats z = 1 / per_z;
  const auto& [x, y] = points.at = {right.value * z, down.value * z};
  points.per_u = {z * (right.per_u - x * slope.per_u), z * (down.per_u - y * slope.per_u)};
  points.per_v = {z * (right.per_v - x * slope.per_v), z * (down.per_v - y * slope.per_v)};
  return picture_light(points);
}

Floats3 ball_base(const Surface& surface, const Floats& from_u, float from_v) {
  const BallPanels panels = ball_panels(at(surface.place, from_u, from_v), at(surface.place, from_u + 1, from_v),
                                        at(surface.place, from_u, from_v + 1));
  const Float3& base = surface.base;
  const float most = std::max({base.x, base.y, base.z}), low = std::min({base.x, base.y, base.z});
  const float dark = 0.03F + 0.42F * std::clamp(2 * (most - low) / std::max(most, 0.01F), 0.0F, 1.0F);
  return all_lanes(base) * (1 - (1 - dark) * panels.pentagon) * (1 - 0.45F * panels.seam);
}

}  // namespace

Floats net_cover_of(const Surface& net, int v, int u, const Floats& per_z) {
  const Floats from_u = lane_numbers() + (static_cast<float>(u) - net.anchor.u);
  const Place place = place_on(net, from_u, static_cast<float>(v) - net.anchor.v, per_z);
  return net_cover(place.at, place.per_u, place.per_v);
}

SolidShading::SolidShading(const Light& light, const LookValues& look, const sensors::Perspective& view, bool grounded,
                           const ShadowLookup* shadows)
    : look_(look),
      shadows_(shadows),
      sky_(floats(light.sky)),
      earth_(floats(light.ground)),
      gloss_(static_cast<float>(light.gloss)) {
  const std::array<Lamp, 3> lamps{Lamp{light.toward, light.lamp}, light.others[0], light.others[1]};
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    toward_[i] = floats((1 / norm(lamps[i].toward)) * transposed_times(view.axes, lamps[i].toward));
    lamp_[i] = floats(lamps[i].lamp);
  }
  up_ = floats(transposed_times(view.axes, Vec3d{0, 0, 1}));
  eye_height_ = static_cast<float>(view.eye.z);
  grounded_ = grounded && light.patterns ? static_cast<float>(ground_darkness) : 0;
  pool_center_ = floats(transposed_times(view.axes, -1.0 * view.eye));
  pool_size_ = light.pool > 0 ? static_cast<float>(1 / (light.pool * light.pool)) : 0;
}

/// `normal`: of any length.
Floats3 SolidShading::shown(const Floats3& base, const Floats3& normal, const Floats& tangent_x, float tangent_y,
                            const Floats& per_z) const {
  const Floats3 n = normal * (1 / root(dot(normal, normal)));
  const Floats z = 1 / per_z;
  const Floats3 p{tangent_x * z, tangent_y * z, z};
  Floats3 light = mixed(all_lanes(earth_), all_lanes(sky_), 0.5F + 0.5F * dot(n, up_));
  light = light * (1 - grounded_ * limited(1 - 6 * (eye_height_ + dot(p, up_)), 0, 1));
  const Floats lit = shadows_ ? shadows_->lit_at(p, n) : all_lanes(1.0F);
  light = light + all_lanes(lamp_[0]) * (lit * greatest(Floats{}, dot(n, toward_[0])));
  for (std::size_t i = 1; i < lamp_.size(); ++i)
    light = light + all_lanes(lamp_[i]) * greatest(Floats{}, dot(n, toward_[i]));
  Floats3 sum = base * light;
  if (gloss_ > 0) {
    const Floats3 to_eye = p * (-1 / root(dot(p, p)));
    for (std::size_t i = 0; i < 2; ++i) {
      const Floats3 half = to_eye + all_lanes(toward_[i]);
      const Floats cosine = dot(n, half) / root(greatest(dot(half, half), all_lanes(1e-12F)));
      const Floats mirrored = gloss_ * mirror_power(cosine);
      sum = sum + all_lanes(lamp_[i]) * (i == 0 ? mirrored * lit : mirrored);
    }
  }
  if (pool_size_ > 0) {
    const Floats3 off = p - all_lanes(pool_center_);
    const Floats pool = 1 / (1 + dot(off, off) * pool_size_);
    sum = sum * (pool * pool);
  }
  return {srgb_of(sum.x), srgb_of(sum.y), srgb_of(sum.z)};
}

Floats3 SolidShading::colors(const PixelRays& rays, const Surface& surface, int v, int u, const Floats& per_z) const {
  const Floats column = lane_numbers() + static_cast<float>(u), from_u = column - surface.anchor.u;
  const float from_v = static_cast<float>(v) - surface.anchor.v;
  switch (surface.kind) {
    case Surface::Kind::wall: {
      const Place place = place_on(surface, from_u, from_v, per_z);
      return wall_look(look_, place.at, place.footprint());
    }
    case Surface::Kind::ceiling: {
      const Place place = place_on(surface, from_u, from_v, per_z);
      return ceiling_look(look_, place.at, place.footprint());
    }
    case Surface::Kind::net: return all_lanes(look_.net);
    case Surface::Kind::solid:
    case Surface::Kind::ball:
    case Surface::Kind::pictured: break;
  }
  Floats3 base = all_lanes(surface.base);
  if (surface.kind == Surface::Kind::ball) base = ball_base(surface, from_u, from_v);
  if (surface.kind == Surface::Kind::pictured) {
    const Place place = place_on(surface, from_u, from_v, per_z);
    PicturePoints points{{}, place.at, place.per_u, place.per_v};
    points.pictures.fill(surface.picture);
    base = base * picture_light(points);
  }
  return shown(base, at(surface.normal, from_u, from_v), rays.tangent_x(column), rays.tangent_y(v), per_z);
}

Floats3 SolidShading::colors(const PixelRays& rays, std::span<const Surface> surfaces, const Ints& numbers,
                             const Ints& seen, int v, int u, const Floats& per_z) const {
  unsigned left = bits_of(seen);
  MUROSIMF_ASSERT(left != 0);
  const auto surface_at = [&](int lane) -> const Surface& { return surfaces[static_cast<std::size_t>(numbers[lane])]; };
  const int lane = std::countr_zero(left);
  const Ints same = seen & (numbers == numbers[lane]);
  if (bits_of(same) == left) return colors(rays, surface_at(lane), v, u, per_z);
  // solids are gathered, all others come one by one
  Floats3 base{}, normal{Floats{}, Floats{}, Floats{} + 1.0F};
  unsigned solid = 0, pictured = 0;
  for (int i = 0; i < pixel_lanes; ++i) {
    if ((left >> i & 1U) == 0) continue;
    const Surface& surface = surface_at(i);
    if (surface.kind != Surface::Kind::solid && surface.kind != Surface::Kind::pictured) continue;
    solid |= 1U << i;
    const float from_u = static_cast<float>(u + i) - surface.anchor.u,
                from_v = static_cast<float>(v) - surface.anchor.v;
    normal.x[i] = surface.normal[0].at(from_u, from_v);
    normal.y[i] = surface.normal[1].at(from_u, from_v);
    normal.z[i] = surface.normal[2].at(from_u, from_v);
    base.x[i] = surface.base.x;
    base.y[i] = surface.base.y;
    base.z[i] = surface.base.z;
    if (surface.picture) pictured |= 1U << i;
  }
  if (pictured != 0) base = base * light_of_pictures(surfaces, numbers, pictured, v, u, per_z);
  Floats3 result{};
  if (solid != 0)
    result = shown(base, normal, rays.tangent_x(lane_numbers() + static_cast<float>(u)), rays.tangent_y(v), per_z);
  left &= ~solid;
  while (left != 0) {
    const int next = std::countr_zero(left);
    const Ints one = seen & (numbers == numbers[next]);
    result = choose(one, colors(rays, surface_at(next), v, u, per_z), result);
    left &= ~bits_of(one);
  }
  return result;
}

}  // namespace murosimf::render::software
