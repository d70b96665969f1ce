#include "murosimf/render/software/ground_shading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/render/software/coverage.h"
#include "murosimf/render/software/fine_pile.h"
#include "murosimf/render/software/seen_corner.h"

namespace murosimf::render::software {
namespace {

constexpr float around =
    1;  // [px] by which parts of rows are larger than outlines: more than half of a pixel's footprint

/// A straight piece in single precision: from its begin along and across it.
struct StrokeFrame {
  explicit StrokeFrame(const StrokePiece& piece) {
    const double dx = piece.end.x - piece.begin.x, dy = piece.end.y - piece.begin.y, length = std::hypot(dx, dy);
    MUROSIMF_ASSERT(length > 0);
    x = static_cast<float>(piece.begin.x);
    y = static_cast<float>(piece.begin.y);
    along_x = static_cast<float>(dx / length);
    along_y = static_cast<float>(dy / length);
    low = static_cast<float>(-piece.begin.beyond);
    high = static_cast<float>(length + piece.end.beyond);
    soft_low = piece.begin.soft ? 0.5F : 0;
    soft_high = piece.end.soft ? 0.5F : 0;
    half_width = static_cast<float>(piece.half_width);
  }
  float x, y, along_x, along_y, low, high, soft_low, soft_high, half_width;
};

/// Pixels relative to a stroke.
struct OnStroke {
  OnStroke(const StrokeFrame& frame, const GroundPlaces& p)
      : along((p.x - frame.x) * frame.along_x + (p.y - frame.y) * frame.along_y),
        across((p.y - frame.y) * frame.along_x - (p.x - frame.x) * frame.along_y),
        along_u(p.xu * frame.along_x + p.yu * frame.along_y),
        along_v(p.xv * frame.along_x + p.yv * frame.along_y),
        footprint_along(length(along_u, along_v)),
        footprint_across(
            length(p.yu * frame.along_x - p.xu * frame.along_y, p.yv * frame.along_x - p.xv * frame.along_y)) {}
  static Footprint length(const Floats& a, const Floats& b) { return Footprint(root(a * a + b * b) + 1e-9F); }
  /// The share of the pixel under the paint, whose edges are `ragged` [m] further in.
  [[nodiscard]] Floats cover(const StrokeFrame& frame, const Floats& ragged) const {
    const Floats& a = footprint_along.size;
    const Floats half = frame.half_width - ragged;
    return share_between(along, frame.low - a * frame.soft_low, frame.high + a * frame.soft_high, footprint_along) *
           share_between(across, -half, half, footprint_across);
  }
  Floats along, across, along_u, along_v;
  Footprint footprint_along, footprint_across;
};

/// Height of the pile where a pixel covers so much [m], and so many cells of the quick one.
Floats pile_at(const LookValues& look, const Floats2& at, const Footprint& covered, const Footprint& cells) {
  return look.fine ? FinePile::get().at(at, covered.size) : pile_at(at, cells);
}

/// How far the paint's edge is worn, by the side of the stroke.
Floats ragged_edge(const LookValues& look, const StrokeFrame& frame, const OnStroke& at) {
  const Floats side = 3 * frame.half_width * (at.across > 0 ? all_lanes(1.0F) : all_lanes(-1.0F));
  const Footprint covered(0.11F * (magnitude(at.along_u) + magnitude(at.along_v)));
  return 0.008F * greatest(Floats{}, pile_at(look, {0.11F * at.along, side}, covered, covered.scaled(250)));
}

/// The outline in the picture: what is too close to the eye, or behind it, is cut off.
std::vector<PicturePoint>& in_picture(const PixelRays& rays, std::span<const Vec3d> outline,
                                      std::vector<PicturePoint>& points) {
  points.clear();
  const auto add = [&](const Float3& p) { points.push_back({rays.u_of(p.x / p.z), rays.v_of(p.y / p.z)}); };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Float3 a = rays.seen(outline[i]), b = rays.seen(outline[(i + 1) % outline.size()]);
    if (a.z >= nearest_z) add(a);
    if ((a.z >= nearest_z) == (b.z >= nearest_z)) continue;
    const float t = (nearest_z - a.z) / (b.z - a.z);
    add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), nearest_z});
  }
  return points;
}

/// Widens the range from `low` to `high` by the columns of a line between two rows.
void widen(const PicturePoint& a, const PicturePoint& b, float top, float bottom, float& low, float& high) {
  if (std::max(a.v, b.v) < top || std::min(a.v, b.v) > bottom) return;
  const auto see = [&](const PicturePoint& p, const PicturePoint& other) {
    float u = p.u;
    if (p.v < top) u += (top - p.v) / (other.v - p.v) * (other.u - p.u);
    if (p.v > bottom) u += (bottom - p.v) / (other.v - p.v) * (other.u - p.u);
    low = std::min(low, u);
    high = std::max(high, u);
  };
  see(a, b);
  see(b, a);
}

/// Calls visit(u, places, mask) for groups of pixels of a part of a row that show the ground, or with `Measured` what is only looked at
/// before it.
template <bool Measured = false, class Visit>
void for_ground(const PixelRays& rays, int v, int first, int last, const std::int32_t* numbers, const Visit& visit) {
  const Floats lanes = lane_numbers();
  const RowRays row = rays.row(v);
  for (int u = first; u <= last; u += pixel_lanes) {
    const Floats column = lanes + static_cast<float>(u);
    const Floats per_z = row.ground.at(column);
    const auto number = load_lanes<Ints>(numbers + u);
    const Ints free = (per_z > 0) & (Measured ? number <= 0 : number == 0) & (column <= static_cast<float>(last));
    if (!any(free)) continue;
    const GroundPlaces places = row.ground_places(column, choose(free, per_z, all_lanes(1.0F)));
    visit(u, places, free & GroundShading::is_there(row, places, per_z));
  }
}

/// In the optical frame.
Floats3 seen_place(const PixelRays& rays, int u, float tangent_y, const GroundPlaces& places) {
  return {rays.tangent_x(lane_numbers() + static_cast<float>(u)) * places.z, tangent_y * places.z, places.z};
}

Floats2 at_of(const GroundPlaces& p) { return {p.x, p.y}; }
Footprints footprints_of(const GroundPlaces& p) {
  return {Footprint(magnitude(p.xu) + magnitude(p.xv)), Footprint(magnitude(p.yu) + magnitude(p.yv))};
}

/// The share of a pixel that the field covers.
Floats field_share(const LookValues& look, const Floats2& at, const Footprints& f) {
  if (!(look.half_length > 0)) return Floats{};
  const Floats beyond =
      greatest((magnitude(at.x) - look.half_length) * f.x.per_size, (magnitude(at.y) - look.half_width) * f.y.per_size);
  return limited(0.5F - beyond, 0, 1);
}

}  // namespace

void RowParts::begin(int height) {
  rows_.resize(static_cast<std::size_t>(height));
  for (auto& row : rows_) row.clear();
}

void RowParts::add(int number, const PixelRays& rays, std::span<const Vec3d> outline, const PixelBox& within) {
  const std::vector<PicturePoint>& points = in_picture(rays, outline, points_);
  if (points.empty()) return;
  const auto [lowest, highest] = std::ranges::minmax(points, {}, &PicturePoint::v);
  const auto row_limit = [&](float v) {
    return std::clamp(v, static_cast<float>(within.top - 1), static_cast<float>(within.bottom + 1));
  };
  const int top = std::max(within.top, static_cast<int>(row_limit(lowest.v - around)));
  const int bottom = std::min(within.bottom, static_cast<int>(row_limit(highest.v + around)));
  for (int v = top; v <= bottom; ++v) {
    float low = 1e9F, high = -1e9F;
    for (std::size_t i = 0; i < points.size(); ++i) {
      widen(points[i], points[(i + 1) % points.size()], static_cast<float>(v) - around, static_cast<float>(v) + around,
            low, high);
    }
    low = std::max(low - around, static_cast<float>(within.left));
    high = std::min(high + around, static_cast<float>(within.right));
    if (low <= high)
      rows_[static_cast<std::size_t>(v)].push_back({number, static_cast<int>(low), static_cast<int>(high)});
  }
}

void GroundShading::begin(const PixelRays& rays, const PixelBox& within, std::vector<ContactShadow> contacts,
                          const ShadowLookup* shadows) {
  shadows_ = shadows;
  stroke_parts_.begin(within.bottom + 1);
  contact_parts_.begin(within.bottom + 1);
  if (!rays.sees_ground_from_above()) return;
  for (std::size_t i = 0; i < strokes_.size(); ++i) {
    const StrokePiece& p = strokes_[i];
    const Vec3d begin{p.begin.x, p.begin.y, 0}, end{p.end.x, p.end.y, 0};
    const Vec3d along = (1 / norm(end - begin)) * (end - begin), side = p.half_width * Vec3d{-along.y, along.x, 0};
    const Vec3d a = begin - p.begin.beyond * along, b = end + p.end.beyond * along;
    stroke_parts_.add(static_cast<int>(i), rays, std::array{a - side, b - side, b + side, a + side}, within);
  }
  contacts_ = std::move(contacts);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const ContactShadow& c = contacts_[i];
    const Vec3d x = (c.half_length + c.reach) * c.along;
    const Vec3d y = (c.half_width + c.reach) * Vec3d{-c.along.y, c.along.x, 0};
    contact_parts_.add(static_cast<int>(i), rays,
                       std::array{c.middle - x - y, c.middle + x - y, c.middle + x + y, c.middle - x + y}, within);
  }
}

void GroundShading::paint(const PixelRays& rays, const LookValues& look, int v, const std::int32_t* numbers,
                          RowColors& colors) const {
  paint_area(rays, look, v, numbers, colors);
  paint_strokes(rays, look, v, numbers, colors);
  if (look.patterns) paint_contacts(rays, v, numbers, colors);
}

void GroundShading::paint_area(const PixelRays& rays, const LookValues& look, int v, const std::int32_t* numbers,
                               RowColors& colors) const {
  const float tangent_y = rays.tangent_y(v);
  for_ground(rays, v, 0, rays.width() - 1, numbers, [&](int u, const GroundPlaces& places, const Ints& there) {
    const Floats2 at = at_of(places);
    const Footprints f = footprints_of(places);
    const Floats field = field_share(look, at, f);
    const Floats lit = shadows_ ? shadows_->lit_at(seen_place(rays, u, tangent_y, places)) : all_lanes(1.0F);
    if (shadows_) store_lanes(lit, colors.lit.data() + u);
    const Floats3 floor = look.floor.at(lit, shadows_), grass = look.grass.at(lit, shadows_);
    const bool all_field = all(field >= 1);
    Floats3 color = all_field ? grass : mixed(floor, grass, field);
    if (look.patterns) {
      const Floats pile = pile_at(look, at, larger(f.x, f.y), pile_cells(f)), pool = pool_tone(look, at);
      store_lanes(pile, colors.pile.data() + u);
      if (any(field > 0)) color = grass * (lawn_tone(look, at, f, pile) * pool);
      if (!all_field) {
        const Float3& middle = rays.around();
        const Floats x = at.x - middle.x, y = at.y - middle.y;
        const Floats away = x * x + y * y + middle.z * middle.z;
        color = mixed(floor_look(look, floor * pool, at, f, pile, away), color, field);
      }
    }
    colors.store(u, all(there) ? color : choose(there, color, colors.load(u)));
  });
}

void GroundShading::paint_strokes(const PixelRays& rays, const LookValues& look, int v, const std::int32_t* numbers,
                                  RowColors& colors) const {
  for (const RowPart& part : stroke_parts_.of(v)) {
    const StrokeFrame frame(strokes_[static_cast<std::size_t>(part.number)]);
    for_ground(rays, v, part.first, part.last, numbers, [&](int u, const GroundPlaces& places, const Ints& there) {
      const OnStroke on(frame, places);
      Floats cover = on.cover(frame, look.patterns ? ragged_edge(look, frame, on) : Floats{});
      Floats3 paint = look.paint.at(load_lanes<Floats>(colors.lit.data() + u), shadows_);
      if (look.patterns) {
        paint = paint * pool_tone(look, at_of(places));
        cover = worn(cover, load_lanes<Floats>(colors.pile.data() + u));
      }
      const Floats3 old = colors.load(u);
      colors.store(u, choose(there, mixed(old, paint, cover), old));
    });
  }
}

void GroundShading::paint_contacts(const PixelRays& rays, int v, const std::int32_t* numbers, RowColors& colors) const {
  for (const RowPart& part : contact_parts_.of(v)) {
    const ContactShadow& shadow = contacts_[static_cast<std::size_t>(part.number)];
    const Float3 middle = floats(shadow.middle), along = floats(shadow.along);
    const auto half_length = static_cast<float>(shadow.half_length), half_width = static_cast<float>(shadow.half_width);
    const auto per_reach = static_cast<float>(1 / shadow.reach), darkness = static_cast<float>(shadow.darkness);
    for_ground(rays, v, part.first, part.last, numbers, [&](int u, const GroundPlaces& places, const Ints& there) {
      const Floats x = places.x - middle.x, y = places.y - middle.y;
      const Floats beyond_x = greatest(magnitude(x * along.x + y * along.y) - half_length, Floats{});
      const Floats beyond_y = greatest(magnitude(y * along.x - x * along.y) - half_width, Floats{});
      const Floats near = limited(1 - root(beyond_x * beyond_x + beyond_y * beyond_y) * per_reach, 0, 1);
      const Floats3 old = colors.load(u);
      colors.store(u, choose(there, old * (1 - darkness * near * near), old));
    });
  }
}

void GroundShading::mark_lines(const PixelRays& rays, int v, const std::int32_t* numbers, std::uint16_t label,
                               std::span<std::uint16_t> labels) const {
  for (const RowPart& part : stroke_parts_.of(v)) {
    const StrokeFrame frame(strokes_[static_cast<std::size_t>(part.number)]);
    for_ground<true>(rays, v, part.first, part.last, numbers,
                     [&](int u, const GroundPlaces& places, const Ints& there) {
                       const unsigned covered =
                           bits_of(there & (OnStroke(frame, places).cover(frame, Floats{}) > 0.5F));
                       for (int i = 0; i < pixel_lanes; ++i) {
                         if ((covered >> i & 1U) != 0) labels[static_cast<std::size_t>(u + i)] = label;
                       }
                     });
  }
}

}  // namespace murosimf::render::software
