/// coverage.h - which pixels a triangle covers, and 1 / z there.
///
/// A pixel belongs to a triangle whose edge functions are not negative at its middle (Pineda, "A parallel algorithm for polygon
/// rasterization", SIGGRAPH 1988). Each edge is evaluated from the same one of its ends for both of its triangles, so that no pixel between
/// them is missed.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "murosimf/render/software/float_lanes.h"

namespace murosimf::render::software {

/// A corner in the picture.
struct Corner {
  float u = 0, v = 0;  ///< [px]
  float per_z = 0;     ///< [1/m] 1 / z; by parallel rays minus the depth [m]
};

/// Pixels that may be covered.
struct PixelBox {
  int left = 0, right = -1, top = 0, bottom = -1;  ///< all of them inside
};

/// Twice the area [px^2]: positive if the corners go clockwise as seen in the picture, whose v points down.
[[nodiscard]] inline float turn_of(const std::array<Corner, 3>& c) {
  return (c[1].u - c[0].u) * (c[2].v - c[0].v) - (c[1].v - c[0].v) * (c[2].u - c[0].u);
}

/// A number that is linear in the picture.
struct Slope {
  float value = 0, per_u = 0, per_v = 0;  ///< value: at an anchor
  [[nodiscard]] Floats at(const Floats& from_u, float from_v) const { return value + per_u * from_u + per_v * from_v; }
  [[nodiscard]] float at(float from_u, float from_v) const { return value + per_u * from_u + per_v * from_v; }
};

/// Where slopes count from: the first corner of a triangle, or the place in the picture that is closest to it. Corners just before the eye
/// are far outside, and numbers there much larger than in the picture.
struct Anchor {
  float u = 0, v = 0;
  Anchor() = default;
  Anchor(const Corner& first, const PixelBox& within)
      : u(std::clamp(first.u, static_cast<float>(within.left), static_cast<float>(within.right))),
        v(std::clamp(first.v, static_cast<float>(within.top), static_cast<float>(within.bottom))) {}
};

/// Slopes of numbers that are given at the corners of a triangle.
class Slopes {
 public:
  /// `turn`: turn_of(c), not 0.
  Slopes(const std::array<Corner, 3>& c, float turn, const Anchor& anchor)
      : second_u_(double{c[1].u} - double{c[0].u}),
        second_v_(double{c[1].v} - double{c[0].v}),
        third_u_(double{c[2].u} - double{c[0].u}),
        third_v_(double{c[2].v} - double{c[0].v}),
        anchor_u_(double{anchor.u} - double{c[0].u}),
        anchor_v_(double{anchor.v} - double{c[0].v}),
        per_turn_(1 / double{turn}) {}
  [[nodiscard]] Slope of(float first, float second, float third) const {
    const double b = double{second} - double{first}, c = double{third} - double{first};
    const double per_u = (b * third_v_ - c * second_v_) * per_turn_, per_v = (c * second_u_ - b * third_u_) * per_turn_;
    return {static_cast<float>(double{first} + per_u * anchor_u_ + per_v * anchor_v_), static_cast<float>(per_u),
            static_cast<float>(per_v)};
  }

 private:
  double second_u_, second_v_, third_u_, third_v_, anchor_u_, anchor_v_, per_turn_;
};

/// Where an edge function is not negative.
class Edge {
 public:
  Edge(const Corner& from, const Corner& to) {
    const bool swapped = std::pair{to.u, to.v} < std::pair{from.u, from.v};
    const Corner &p = swapped ? to : from, &q = swapped ? from : to;
    u_ = p.u;
    v_ = p.v;
    const float sign = swapped ? -1.0F : 1.0F;
    across_ = sign * (q.u - p.u);
    down_ = sign * (q.v - p.v);
  }
  /// In a row: at(u) = row_value(v) - down (u - u of the end).
  [[nodiscard]] float row_value(float v) const { return across_ * (v - v_); }
  [[nodiscard]] Floats at(float row_value, const Floats& u) const { return row_value - down_ * (u - u_); }
  /// Narrows the part of a row, to a pixel more than the edge leaves.
  void narrow(float row_value, float& low, float& high) const {
    if (down_ > 0) high = std::min(high, u_ + row_value / down_ + 1);
    if (down_ < 0) low = std::max(low, u_ + row_value / down_ - 1);
  }

 private:
  float u_, v_, across_, down_;
};

/// The pixels of `within` whose middles a triangle may cover.
[[nodiscard]] inline PixelBox box_of(const std::array<Corner, 3>& c, const PixelBox& within) {
  const auto up = [](float x) {
    const int cut = static_cast<int>(x);
    return static_cast<float>(cut) < x ? cut + 1 : cut;
  };
  const auto down = [](float x) {
    const int cut = static_cast<int>(x);
    return static_cast<float>(cut) > x ? cut - 1 : cut;
  };
  const auto limits = [](float a, float b, float c3, int low, int high) {
    // compared as floats: corners close to the eye are beyond all whole numbers
    const auto lowest = static_cast<float>(low - 1), highest = static_cast<float>(high + 1);
    return std::pair{std::clamp(std::min({a, b, c3}), lowest, highest),
                     std::clamp(std::max({a, b, c3}), lowest, highest)};
  };
  const auto [left, right] = limits(c[0].u, c[1].u, c[2].u, within.left, within.right);
  const auto [top, bottom] = limits(c[0].v, c[1].v, c[2].v, within.top, within.bottom);
  return {std::max(within.left, up(left)), std::min(within.right, down(right)), std::max(within.top, up(top)),
          std::min(within.bottom, down(bottom))};
}

/// Calls visit(v, u, mask, per_z) for groups of pixels of which the triangle covers some: the pixels u, u + 1, ... of the row v. The corners
/// go clockwise in the picture.
template <class Visit>
void for_covered(const std::array<Corner, 3>& c, const Slope& per_z, const Anchor& anchor, const PixelBox& within,
                 const Visit& visit) {
  const PixelBox box = box_of(c, within);
  if (box.left > box.right || box.top > box.bottom) return;
  const std::array<Edge, 3> edges{Edge(c[0], c[1]), Edge(c[1], c[2]), Edge(c[2], c[0])};
  // the slopes of a sliver are not exact: 1 / z stays between those of its corners
  const float least_per_z = std::min({c[0].per_z, c[1].per_z, c[2].per_z});
  const float most_per_z = std::max({c[0].per_z, c[1].per_z, c[2].per_z});
  const bool wide = box.right - box.left >= 2 * pixel_lanes;
  const Floats numbers = lane_numbers();
  for (int v = box.top; v <= box.bottom; ++v) {
    const auto row = static_cast<float>(v);
    std::array<float, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) values[i] = edges[i].row_value(row);
    int first = box.left, last = box.right;
    if (wide) {
      auto low = static_cast<float>(first), high = static_cast<float>(last);
      for (std::size_t i = 0; i < 3; ++i) edges[i].narrow(values[i], low, high);
      if (!(low <= high)) continue;
      first = static_cast<int>(low);
      last = static_cast<int>(high);
    }
    const float row_per_z = per_z.value + per_z.per_v * (row - anchor.v);
    for (int u = first; u <= last; u += pixel_lanes) {
      const Floats at = numbers + static_cast<float>(u);
      Ints inside = edges[0].at(values[0], at) >= 0;
      inside &= edges[1].at(values[1], at) >= 0;
      inside &= edges[2].at(values[2], at) >= 0;
      inside &= at <= static_cast<float>(last);
      if (!any(inside)) continue;
      visit(v, u, inside, limited(row_per_z + per_z.per_u * (at - anchor.u), least_per_z, most_per_z));
    }
  }
}

}  // namespace murosimf::render::software
