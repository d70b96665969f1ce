/// hull.h - the convex hull of points, by qhull.
///
/// Faces that lie in one plane are one face: joined are neighbors that differ by less than `plane_tolerance` times the
/// size, the rounding of files in single precision. Nothing else is simplified, unless there are more than `many_points`:
/// then points that stand out by less than `thinning` times the size are left out. Such a hull lies inside the exact one,
/// nowhere farther than that; a smooth body of 490,000 vertices takes 2 s, where the exact hull took minutes.
/// Source: Barber, Dobkin, Huhdanpaa, "The Quickhull algorithm for convex hulls", ACM TOMS 22 (1996).
#pragma once

#include <cstddef>
#include <span>

#include "murosimf/model/shape.h"

namespace murosimf::geometry {

constexpr double plane_tolerance = 1e-7;     ///< [1] of the largest half size; single precision rounds by 6e-8
constexpr double least_thickness = 1e-6;     ///< [1] of the largest half size; what is thinner counts as flat
constexpr std::size_t many_points = 20'000;  ///< of which a hull is thinned out
constexpr double thinning = 5e-4;            ///< [1] of the largest half size: 0.05 mm on a body that is 20 cm wide
/// A hull of more vertices makes contact tests slow; readers of files warn about it.
constexpr std::size_t many_vertices = 256;

struct Hull {
  ConvexHull hull;   ///< the middle of its axis-aligned box is the origin
  Vec3d middle;      ///< [m] where that is in the frame of the points
  double error = 0;  ///< [m] how far the exact hull may stand out, because there were many points
};

/// Vertices stand in the order of the points, each face begins with its lowest vertex, faces and neighbors are sorted:
/// the same points give the same hull. Throws SetupError if there are fewer than four points, if they are not finite,
/// or if they lie in a plane.
[[nodiscard]] Hull make_hull(std::span<const Vec3d> points);

}  // namespace murosimf::geometry
