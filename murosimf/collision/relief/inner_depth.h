/// inner_depth.h - how thick the solid below the triangles of a mesh is.
#pragma once

#include <span>
#include <vector>

#include "murosimf/collision/relief/relief.h"

namespace murosimf::collision {

/// [m] Half of the way against a triangle's normal to the next triangle, or what was given as most; a tenth of a millimeter at least.
struct InnerDepth {
  double middle = 0;  ///< from the middle of the triangle
  double least =
      0;  ///< the same, or from near a corner: a prism of that depth does not stand out of the solid's other side
};

/// Of each triangle.
[[nodiscard]] std::vector<InnerDepth> inner_depths(std::span<const ReliefTriangle> triangles, double most);

}  // namespace murosimf::collision
