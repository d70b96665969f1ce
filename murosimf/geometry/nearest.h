/// nearest.h - the point of a surface that is nearest to a given point.
#pragma once

#include "murosimf/model/shape.h"

namespace murosimf::geometry {

/// A point of a surface, seen from some point p.
struct Nearest {
  Vec3d point;          ///< [m] on the surface
  Vec3d normal;         ///< [1] unit, outwards: along p - point if p is outside, against it if p is inside
  double distance = 0;  ///< [m] of p from it, negative if p is inside
};

/// All lengths [m] and frames are the shape's own; p may be anywhere.
[[nodiscard]] Nearest nearest_on_ellipsoid(const Vec3d& semi_axes, const Vec3d& p);
/// Of a polyhedron, by all its faces.
[[nodiscard]] Nearest nearest_on_hull(const ConvexHull& hull, const Vec3d& p);

}  // namespace murosimf::geometry
