/// polygon_triangles.h - a flat polygon, which may be concave, as triangles: ear clipping.
///
/// An ear is a corner that forms, with its neighbors, a triangle without other corners in it; ears are cut off one after the other. Source: Meisters,
/// "Polygons have ears", Amer. Math. Monthly 82 (1975).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/math/vec3.h"

namespace murosimf::render {

/// Numbers of corners, of each triangle in the order of the polygon; together they cover it exactly. Of n corners n - 2
/// triangles, fewer where some lie in a line. A border that crosses itself, or corners that do not lie in a plane, give some triangles of them.
/// Takes time as n for convex ones, as n times the concave corners for most others, as n^3 at worst.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> polygon_triangles(std::span<const Vec3d> corners);

/// Whether no corner turns the other way, for a flat polygon with a border that does not cross itself.
[[nodiscard]] bool is_convex(std::span<const Vec3d> corners);

}  // namespace murosimf::render
