/// fitting_frame.h - how a convex polyhedron spreads its mass, and frames along which a primitive may stand for it.
#pragma once

#include "murosimf/model/shape.h"

namespace murosimf::geometry {

/// Lowest and highest coordinate along the axes of a frame at the hull's origin.
struct Bounds {
  Vec3d low, high;  ///< [m]
};
[[nodiscard]] Bounds bounds_in(const ConvexHull& hull, const Mat3d& frame);

struct SolidShape {
  double volume = 0;  ///< [m^3]
  Vec3d center;       ///< [m] of mass, hull frame
  SymMat3d spread;    ///< [m^2] second moments of a unit mass about the center, hull axes
  Mat3d principal;    ///< principal axes, seen in the hull's frame
  Mat3d tightest;     ///< of the frames of primitive_fit.h the one with the smallest bounding box

  /// Second moments along the axes of a frame [m^2].
  [[nodiscard]] Vec3d moments(const Mat3d& frame) const {
    return {dot(frame.x, spread * frame.x), dot(frame.y, spread * frame.y), dot(frame.z, spread * frame.z)};
  }
};

/// The volume of `hull` must be positive.
[[nodiscard]] SolidShape solid_shape(const ConvexHull& hull);

}  // namespace murosimf::geometry
