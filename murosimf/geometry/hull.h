/// hull.h - the convex hull of points, by qhull.
///
/// Faces that lie in one plane are one face: joined are neighbors that differ by less than `plane_tolerance` times the
/// size, the rounding of files in single precision. Nothing else is simplified.
/// Source: Barber, Dobkin, Huhdanpaa, "The Quickhull algorithm for convex hulls", ACM TOMS 22 (1996).
#pragma once

#include <cstddef>
#include <span>

#include "murosimf/model/shape.h"

namespace murosimf::geometry {

constexpr double plane_tolerance = 1e-7;  ///< [1] of the largest half size; single precision rounds by 6e-8
constexpr double least_thickness = 1e-6;  ///< [1] of the largest half size; what is thinner counts as flat
/// A hull of more vertices makes contact tests slow; who reads files warns about it.
constexpr std::size_t many_vertices = 256;

struct Hull {
  ConvexHull hull;  ///< the middle of its axis-aligned box is the origin
  Vec3d middle;     ///< [m] where that is in the frame of the points
};

/// Vertices stand in the order of the points, each face begins with its lowest vertex, faces and neighbors are sorted:
/// the same points give the same hull. Throws SetupError if there are fewer than four points, if they are not finite,
/// or if they lie in a plane.
[[nodiscard]] Hull make_hull(std::span<const Vec3d> points);

}  // namespace murosimf::geometry
