/// facing.h - the side of a shape that faces a direction.
#pragma once

#include "murosimf/geometry/manifold.h"
#include "murosimf/geometry/outline.h"
#include "murosimf/geometry/segments.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

inline constexpr int most_corners = 24;  ///< of a face; of faces that have more, every second, third ... counts

/// A face cut by another one may have as many as both.
using Side = Outline<2 * most_corners>;

/// The face, edge or point of the shape that looks along the unit vector d, world frame. A cylinder shows the 16 corners
/// of a polygon in a cap's rim, fixed to it, or a line of its side; a capsule a line; sphere and ellipsoid a point.
void find_facing(const Shape& shape, const Transformd& at, const Vec3d& d, Side& side);

/// The straight line of a side that is farthest along d; none (half is zero) for points and rims.
[[nodiscard]] Segment line_facing(const Shape& shape, const Side& side, const Vec3d& d, std::uint32_t& name);

}  // namespace murosimf::geometry
