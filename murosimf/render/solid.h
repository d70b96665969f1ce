/// solid.h - surfaces as triangles with normals, for drawing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/math/vec3.h"
#include "murosimf/model/shape.h"

namespace murosimf::render {

/// A corner: place [m] and unit normal, in the frame of the solid.
struct Corner {
  std::array<float, 3> place{}, normal{};
  friend bool operator==(const Corner&, const Corner&) = default;
  friend bool operator<(const Corner& a, const Corner& b) {
    return a.place != b.place ? a.place < b.place : a.normal < b.normal;
  }
};

struct Solid {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> triangles;  ///< three corners each, counterclockwise seen from outside
  [[nodiscard]] std::size_t triangle_count() const { return triangles.size() / 3; }
};

/// Round solids have `segments` around (a multiple of 4). Seen along their axis they cover the same area as what they
/// stand for: their corners stand out a little, the middles of their sides stand in. From aside a sphere covers up to a
/// share of 5.5 / segments^2 less.
[[nodiscard]] Solid unit_sphere(int segments);       ///< radius 1
[[nodiscard]] Solid unit_half_sphere(int segments);  ///< radius 1, z > 0, open below
[[nodiscard]] Solid unit_tube(int segments);         ///< radius 1, z from -1 to 1, open
[[nodiscard]] Solid unit_cylinder(int segments);     ///< the same, closed
[[nodiscard]] Solid unit_box();                      ///< from -1 to 1

/// Flat faces.
[[nodiscard]] Solid solid_of(const ConvexHull& hull);

/// Of a mesh. Triangles that meet at less than `crease` [rad] are shaded as one smooth surface; those without area are
/// left out.
[[nodiscard]] Solid solid_of(std::span<const Vec3d> vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
                             double crease = 0.7);

}  // namespace murosimf::render
