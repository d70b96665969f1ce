/// outline.h - faces, edges and points of shapes that face each other, and cutting one by the sides of the other.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "murosimf/math/vec3.h"

namespace murosimf::geometry {

/// A number from two, the same for either order; used for the names of what meets.
[[nodiscard]] constexpr std::uint32_t joined(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t low = a < b ? a : b, high = a < b ? b : a;
  std::uint32_t h = (low + 1) * 0x9E3779B1u ^ (high + 1) * 0x85EBCA77u;
  h ^= h >> 15;
  h *= 0x2C1B3C6Du;
  return h ^ h >> 13;
}

struct Corner {
  Vec3d point;             ///< [m] world frame
  std::uint32_t name = 0;  ///< of this corner
  std::uint32_t side = 0;  ///< name of the line to the next corner
};

/// A convex polygon, counterclockwise seen from outside; of two corners: an edge; of one: a point.
template <int Most>
struct Outline {
  int count = 0;
  std::array<Corner, Most> corners;
  Vec3d normal;            ///< [1] unit, outwards; without meaning for edges and points
  std::uint32_t name = 0;  ///< of this face

  void add(const Vec3d& point, std::uint32_t corner_name) {
    if (count < Most) corners[count++] = {point, corner_name, 0};
  }
  /// To be called when all corners are there.
  void name_sides() {
    for (int i = 0; i < count; ++i) corners[i].side = joined(corners[i].name, corners[(i + 1) % count].name);
  }
};

/// A half space: what is above `height` along `out` is cut off.
struct Cut {
  Vec3d out;
  double height = 0;
  std::uint32_t name = 0;

  [[nodiscard]] double above(const Vec3d& point) const { return dot(out, point) - height; }
};

/// Keeps of the outline what is not above the cut (Sutherland and Hodgman, 1974). A corner that is cut gets its name from
/// the two lines that cross in it.
template <int Most>
void clip(Outline<Most>& outline, const Cut& cut) {
  const int count = outline.count;
  if (count == 0) return;
  std::array<double, Most> above;
  bool any = false;
  for (int i = 0; i < count; ++i) {
    above[i] = cut.above(outline.corners[i].point);
    any = any || above[i] > 0;
  }
  if (!any) return;
  const auto old = outline.corners;
  outline.count = 0;
  const auto keep = [&](const Corner& corner) {
    if (outline.count < Most) outline.corners[outline.count++] = corner;
  };
  for (int i = 0; i < count; ++i) {
    const int j = i + 1 == count ? 0 : i + 1;
    if (!(above[i] > 0)) keep(old[i]);
    if ((above[i] > 0) == (above[j] > 0)) continue;
    if (count == 2 && i == 1) continue;  // an edge is crossed once
    const Vec3d point = old[i].point + above[i] / (above[i] - above[j]) * (old[j].point - old[i].point);
    keep({point, joined(old[i].side, cut.name), above[i] > 0 ? old[i].side : cut.name});
  }
}

/// Cuts `incident` by the sides of the face `reference`, which stand along `out`: what is left lies, seen along it, on the
/// face.
template <int Most, int MostReference>
void clip_by_sides(Outline<Most>& incident, const Outline<MostReference>& reference, const Vec3d& out) {
  for (int i = 0; i < reference.count && incident.count > 0; ++i) {
    const Corner& a = reference.corners[i];
    const Vec3d along = reference.corners[i + 1 == reference.count ? 0 : i + 1].point - a.point;
    const Vec3d side = cross(along, out);
    clip(incident, {side, dot(side, a.point), a.side});
  }
}

}  // namespace murosimf::geometry
