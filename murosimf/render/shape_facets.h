/// shape_facets.h - the surface of a shape as flat polygons, to be drawn.
#pragma once

#include <vector>

#include "murosimf/model/shape.h"

namespace murosimf::render {

/// A flat convex polygon: corners [m] counterclockwise seen from outside.
using Facet = std::vector<Vec3d>;

/// In the shape's frame. Round shapes have 24 facets around and leave their surface by less than 2 % of their radius.
/// A plane has none.
[[nodiscard]] std::vector<Facet> shape_facets(const Shape& shape);

/// Corners of the convex hull of points, by x and y alone, counterclockwise; fewer than three if they lie on a line.
/// Method: Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
[[nodiscard]] std::vector<Vec3d> outline(std::vector<Vec3d> points);

}  // namespace murosimf::render
